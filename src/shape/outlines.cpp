#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/shape/primitives.h"
#include "rounds.h"

namespace roomgen::shape {

namespace {

// A rectangle whose corners are quarters of ellipses with these half axes. The ends of a quarter
// are corners of the curve, so that the straight sides between them stay straight.
Curve<Vec2> rounded_rectangle(const Vec2& half, const Vec2& radii, double tolerance) {
  const int steps = std::max(2, arc_steps(pi / 2, radii.maxCoeff(), tolerance));
  Curve<Vec2> curve{{}, {}, true};
  const auto add = [&curve](const Vec2& point, bool corner) {
    if (corner) curve.corners.push_back(curve.points.size());
    curve.points.push_back(point);
  };
  const Vec2 inner = half - radii;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double sx = quarter == 0 || quarter == 3 ? 1 : -1, sy = quarter < 2 ? 1 : -1;
    for (int k = 0; k <= steps; ++k) {
      // Odd quarters run the other way, so that all four have the same numbers.
      const double angle = pi / 2 * (quarter % 2 ? steps - k : k) / steps;
      const Vec2 arc(k == (quarter % 2 ? 0 : steps) ? 0.0 : std::cos(angle) * radii.x(),
                     std::sin(angle) * radii.y());
      add({sx * (inner.x() + arc.x()), sy * (inner.y() + arc.y())}, k == 0 || k == steps);
    }
  }
  return curve;
}

}  // namespace

Curve<Vec2> ellipse(const Vec2& size, double tolerance) {
  Curve<Vec2> curve{{}, {}, true};
  for (const auto& v : circle(circle_sides(0.5 * size.maxCoeff(), tolerance)))
    curve.points.push_back(0.5 * v.cwiseProduct(size));
  return curve;
}

Curve<Vec2> rectangle(const Vec2& size, double bevel, double tolerance) {
  const Vec2 half = 0.5 * size;
  const double radius = std::min(bevel, half.minCoeff());
  if (!(radius > 0))
    return straight(std::vector<Vec2>{half, {-half.x(), half.y()}, -half, {half.x(), -half.y()}},
                    true);
  return rounded_rectangle(half, Vec2::Constant(radius), tolerance);
}

Curve<Vec2> rounded(const Vec2& size, double round, double tolerance) {
  if (!(round > 0)) return rectangle(size, 0.0, tolerance);
  if (round >= 1) return ellipse(size, tolerance);
  return rounded_rectangle(0.5 * size, 0.5 * round * size, tolerance);
}

}  // namespace roomgen::shape
