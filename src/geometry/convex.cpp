#include "roomgen/geometry/convex.h"

#include <utility>

namespace roomgen {

namespace {

constexpr double sliver = 1e-8;  // m2

// The part of a convex polygon to the left of a line (Sutherland and Hodgman 1974).
Polygon clip(const Polygon& polygon, const Vec2& on_line, const Vec2& direction) {
  Polygon result;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = polygon.points[i];
    const Vec2& b = polygon.points[(i + 1) % n];
    const double at_a = cross(direction, Vec2(a - on_line));
    const double at_b = cross(direction, Vec2(b - on_line));
    if (at_a >= 0) result.points.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
      result.points.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return result;
}

bool has_area(const Polygon& polygon) {
  return polygon.size() >= 3 && area(polygon) > sliver;
}

std::vector<Polygon> triangles_of(const Polygon& polygon) {
  std::vector<Polygon> triangles;
  for (const auto& t : triangulate(polygon))
    triangles.push_back({{polygon.points[t[0]], polygon.points[t[1]], polygon.points[t[2]]}});
  return triangles;
}

// Both convex: what lies outside one edge after the other.
void subtract_convex(const Polygon& piece, const Polygon& hole, std::vector<Polygon>& left) {
  std::vector<Polygon> outside;
  Polygon rest = piece;
  for (std::size_t k = 0; k < hole.size(); ++k) {
    const Segment edge = hole.edge(k);
    Polygon beyond = clip(rest, edge.a, edge.a - edge.b);
    if (has_area(beyond)) outside.push_back(std::move(beyond));
    rest = clip(rest, edge.a, edge.b - edge.a);
    if (!has_area(rest)) {
      left.push_back(piece);
      return;
    }
  }
  left.insert(left.end(), outside.begin(), outside.end());
}

}  // namespace

std::vector<Polygon> subtract(const std::vector<Polygon>& tiles, const Polygon& hole) {
  std::vector<Polygon> left;
  const auto holes = triangles_of(hole);
  for (const auto& tile : tiles) {
    if (!bounds(tile).overlaps(bounds(hole))) {
      left.push_back(tile);
      continue;
    }
    std::vector<Polygon> pieces = triangles_of(tile);
    for (const auto& triangle : holes) {
      std::vector<Polygon> next;
      for (const auto& piece : pieces) subtract_convex(piece, triangle, next);
      pieces = std::move(next);
    }
    left.insert(left.end(), pieces.begin(), pieces.end());
  }
  return left;
}

}  // namespace roomgen
