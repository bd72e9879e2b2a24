#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomgen/geometry/vec.h"

namespace roomgen::shape {

/// The greatest angle of an arc whose chord stays within `tolerance` of it; at most an eighth turn.
inline double arc_step(double radius, double tolerance) {
  const double sag = std::min(tolerance / std::max(radius, 1e-9), 1.0);
  return std::min(2.0 * std::acos(1.0 - sag), pi / 4);
}

/// How many sides stand for a circle: a multiple of four, so that it fills its box.
inline int circle_sides(double radius, double tolerance) {
  const int least = radius > 6 * tolerance ? 12 : 8;
  const int quarter = static_cast<int>(std::ceil(0.5 * pi / arc_step(radius, tolerance) - 1e-9));
  return std::clamp(4 * quarter, least, 512);
}

/// Steps for a part of a circle.
inline int arc_steps(double angle, double radius, double tolerance) {
  return std::max(1, static_cast<int>(std::ceil(angle / arc_step(radius, tolerance) - 1e-9)));
}

/// Unit vectors counter-clockwise from the back (+Y), `sides` a multiple of four. The four quarters
/// repeat the same numbers, so that what is symmetric stays so to the last bit.
inline std::vector<Vec2> circle(int sides) {
  std::vector<Vec2> result;
  const int quarter = sides / 4;
  for (int turn = 0; turn < 4; ++turn)
    for (int k = 0; k < quarter; ++k) {
      const double angle = 2 * pi * k / sides;
      Vec2 v(-std::sin(angle), std::cos(angle));
      for (int t = 0; t < turn; ++t) v = left_of(v);
      result.push_back(v);
    }
  return result;
}

}  // namespace roomgen::shape
