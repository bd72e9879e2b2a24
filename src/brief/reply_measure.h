#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json.h"

namespace roomgen::brief {

inline constexpr double centimetre = 0.01;  ///< metres

/// A number in an answer: "y: 1.2 m".
struct Measure {
  double value = 0.0;  ///< metres if it has a unit
  bool has_unit = false;
  std::string label;  ///< the last word before it, in lower case: "y"
};

/// The numbers of a value: itself, those in its text, those of its elements or members.
std::vector<Measure> measures_in(const Json& value);

/// The only number of a value.
std::optional<Measure> single_measure(const Json& value);

/// A whole number, also in words ("two", "2 pieces").
std::optional<int> count_in(const Json& value);

}  // namespace roomgen::brief
