#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "token.h"

namespace roomgen::language {

/// A number in a text.
struct Number {
  double value = 0.0;
  std::size_t length = 0;    ///< tokens
  bool has_article = false;  ///< begins with an article: "a dozen", "a hundred"
};

/// The number that begins at a token, in figures or in words: 2, 1 1/2, twenty-one, two hundred and
/// five, a dozen, half a dozen, two and a half, half, a quarter. Articles alone are none, nor are
/// ordinals.
std::optional<Number> number_at(std::span<const Token> tokens, std::size_t at);

/// The place of an ordinal, in figures or as a word: 3rd, third.
std::optional<int> ordinal_at(std::span<const Token> tokens, std::size_t at);

}  // namespace roomgen::language
