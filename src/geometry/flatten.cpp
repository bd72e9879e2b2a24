#include "flatten.h"

#include <algorithm>
#include <cmath>

namespace roomgen::detail {

namespace {

constexpr double nothing = 1e-9;  // an arc so short, or of such an ellipse, is a line

int steps_of_curve(const SvgPathOptions& options) { return std::max(1, options.curve_steps); }

int steps_of_arc(double angle, const SvgPathOptions& options) {
  if (options.arc_step <= 0.0) return steps_of_curve(options);
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / options.arc_step)));
}

}  // namespace

std::vector<Vec2> flatten_quadratic(const Vec2& start, const Vec2& control, const Vec2& end,
                                    const SvgPathOptions& options) {
  const int steps = steps_of_curve(options);
  std::vector<Vec2> points;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, u = 1.0 - t;
    points.push_back(u * u * start + 2 * u * t * control + t * t * end);
  }
  return points;
}

std::vector<Vec2> flatten_cubic(const Vec2& start, const Vec2& first, const Vec2& second,
                                const Vec2& end, const SvgPathOptions& options) {
  const int steps = steps_of_curve(options);
  std::vector<Vec2> points;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, u = 1.0 - t;
    points.push_back(u * u * u * start + 3 * u * u * t * first + 3 * u * t * t * second +
                     t * t * t * end);
  }
  return points;
}

// SVG 1.1, F.6.5: turning and scaling make a circle of the ellipse through both ends.
std::vector<Vec2> flatten_arc(const Vec2& start, const EllipticalArc& arc, const Vec2& end,
                              const SvgPathOptions& options) {
  if (arc.radii.minCoeff() < nothing || (end - start).norm() < nothing) return {end};
  const auto to_circle = [&](const Vec2& p) {
    return Vec2(rotated(p, -arc.turn).cwiseQuotient(arc.radii));
  };
  const Vec2 a = to_circle(start), b = to_circle(end);
  const double half = 0.5 * (b - a).norm();
  if (!std::isnormal(half)) return {end};  // radii beyond all proportion
  const double radius = std::max(1.0, half);
  const double apothem = std::sqrt(std::max(0.0, radius * radius - half * half));
  const Vec2 side = left_of(Vec2((b - a) / (2.0 * half)));
  const Vec2 center = 0.5 * (a + b) + (arc.large == arc.sweep ? -1.0 : 1.0) * apothem * side;
  const double first = std::atan2((a - center).y(), (a - center).x());
  double angle = std::atan2((b - center).y(), (b - center).x()) - first;
  if (arc.sweep && angle < 0) angle += 2.0 * pi;
  if (!arc.sweep && angle > 0) angle -= 2.0 * pi;
  const int steps = steps_of_arc(angle, options);
  std::vector<Vec2> points;
  for (int i = 1; i < steps; ++i) {
    const Vec2 on_circle = center + rotated(Vec2(radius, 0), first + angle * i / steps);
    points.push_back(rotated(Vec2(on_circle.cwiseProduct(arc.radii)), arc.turn));
  }
  points.push_back(end);
  return points;
}

}  // namespace roomgen::detail
