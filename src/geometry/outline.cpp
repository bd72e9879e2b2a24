#include "outline.h"

#include <string>

#include "svg_path.h"

namespace roomgen {

namespace {

constexpr double same_point = 1e-9;
constexpr double greatest = 1e6;  // coordinates beyond it are nonsense

std::vector<Vec2> without_repeated(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (const auto& point : points)
    if (kept.empty() || (point - kept.back()).norm() > same_point) kept.push_back(point);
  if (kept.size() > 1 && (kept.back() - kept.front()).norm() < same_point) kept.pop_back();
  return kept;
}

}  // namespace

Result<std::vector<Vec2>> outline_of_path(std::string_view path, int arc_steps) {
  if (path.size() > max_path_bytes)
    return Error{Error::Kind::limit,
                 "a path has at most " + std::to_string(max_path_bytes) + " bytes"};
  const auto subpaths = read_svg_path(
      path, {.curve_steps = arc_steps, .most_subpaths = 1, .greatest = greatest});
  if (!subpaths) return subpaths.error();
  std::vector<Vec2> points;
  if (!subpaths->empty()) points = without_repeated(subpaths->front().points);
  if (points.size() >= 3 && points.size() <= max_outline_points) return points;
  return Error{Error::Kind::invalid_input,
               "path, byte " + std::to_string(path.size()) + ": an outline has 3 to " +
                   std::to_string(max_outline_points) + " points"};
}

std::vector<Vec2> clipped(const std::vector<Vec2>& outline, const Vec2& normal, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    const double over_a = normal.dot(a) - offset, over_b = normal.dot(b) - offset;
    if (over_a <= 0) kept.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      kept.push_back(a + over_a / (over_a - over_b) * (b - a));
  }
  return kept;
}

}  // namespace roomgen
