#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/geometry/vec.h"

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

/// Width, depth and height as an answer has them, by their names if it gives those.
struct SaidSides {
  Vec3 sides = Vec3::Constant(std::nan(""));  ///< metres if they have units; NaN: not said
  bool has_units = false;
};
SaidSides sides_in(std::vector<Measure> measures);
/// Whether a measure is labelled as one of them: "width", "h".
bool names_side(const Measure& measure);

/// What a size in an answer may be: metres, and the unit of mere numbers.
struct SizeForm {
  double least = 0.01, most = 20.0;
  double unit = centimetre;
};
/// All three sides, none but those within the form's bounds; else nothing.
std::optional<Vec3> size_in(const Json& value, const SizeForm& form);

/// A whole number, also in words ("two", "2 pieces").
std::optional<int> count_in(const Json& value);

}  // namespace roomgen::brief
