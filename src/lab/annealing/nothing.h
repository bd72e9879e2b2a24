#pragma once

#include <cmath>
#include <limits>

namespace roomgen::lab::annealing {

/// What a number is that measures nothing: an operand had no members.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
inline bool is_nothing(double value) { return std::isnan(value); }

}  // namespace roomgen::lab::annealing
