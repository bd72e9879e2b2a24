#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "token.h"

namespace roomgen::language {

/// How many or how much of something: "eight", "8 to 12", "between 30 and 40 %", "about a dozen", "at least three",
/// "two thirds".
struct Amount {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  bool is_share = false;   ///< of a whole: per cent (as shares, 0.4 of 40 %) and fractions
  bool is_about = false;   ///< "around 20": the bounds are what was said, once; how far about reaches is for who asks
  std::size_t length = 0;  ///< tokens

  bool is_single() const { return low == high; }
};

/// Least and most of what is counted: "about" reaches a fifth to either side, in whole numbers.
std::pair<double, double> counted_bounds(const Amount& amount);

/// The amount that begins at a token, with the words that bound it before and behind ("or more"). Whole numbers
/// that are excluded ("fewer than five") bound by their neighbour. Articles alone are none.
std::optional<Amount> amount_at(std::span<const Token> tokens, std::size_t at);

}  // namespace roomgen::language
