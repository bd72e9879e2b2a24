#include "triangulate.h"

#include <optional>

#include "rings.h"

namespace roomgen {

namespace {

// The smallest outer loop around each hole; holes without one are left out.
std::vector<std::vector<std::size_t>> holes_of(const std::vector<Loop>& loops,
                                               const std::vector<double>& areas) {
  std::vector<std::vector<std::size_t>> result(loops.size());
  for (std::size_t hole = 0; hole < loops.size(); ++hole) {
    if (areas[hole] >= 0) continue;
    std::optional<std::size_t> best;
    for (std::size_t outer = 0; outer < loops.size(); ++outer)
      if (areas[outer] > -areas[hole] && (!best || areas[outer] < areas[*best]) &&
          contains(Polygon{loops[outer]}, loops[hole].front()))
        best = outer;
    if (best) result[*best].push_back(hole);
  }
  return result;
}

}  // namespace

bool is_simple(const Loop& loop) {
  const std::size_t n = loop.size();
  const auto edge = [&](std::size_t i) { return Segment{loop[i], loop[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (detail::boxes_touch(edge(i), edge(j)) && intersects(edge(i), edge(j))) return false;
    }
  return n >= 3;
}

std::vector<Triangle> triangulate(const std::vector<Loop>& loops) {
  std::vector<Vec2> points;
  std::vector<detail::Ring> rings;
  std::vector<double> areas;
  for (const auto& loop : loops) {
    auto& ring = rings.emplace_back();
    for (const auto& point : loop) {
      ring.push_back(static_cast<detail::Index>(points.size()));
      points.push_back(point);
    }
    areas.push_back(signed_area(loop));
  }
  const auto holes = holes_of(loops, areas);
  std::vector<Triangle> triangles;
  for (std::size_t outer = 0; outer < loops.size(); ++outer) {
    if (areas[outer] <= 0) continue;
    std::vector<detail::Ring> inside;
    for (auto hole : holes[outer]) inside.push_back(rings[hole]);
    detail::clip_ears(points, detail::bridged(points, rings[outer], inside), triangles);
  }
  detail::flip_diagonals(points, triangles);
  return triangles;
}

std::vector<Triangle> triangulate(const Polygon& polygon) {
  return triangulate(std::vector<Loop>{polygon.points});
}

}  // namespace roomgen
