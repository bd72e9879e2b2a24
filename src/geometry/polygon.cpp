#include "roomgen/geometry/polygon.h"

#include <algorithm>
#include <limits>
#include <string>

#include "inside.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

Error polygon_error(const std::string& what) {
  return {Error::Kind::invalid_input, "polygon: " + what};
}

std::string coordinates(const Vec2& p) {
  return "(" + format_number(p.x()) + ", " + format_number(p.y()) + ")";
}

// Removes points that repeat their neighbour or lie on the line between their neighbours.
void drop_needless_points(std::vector<Vec2>& points) {
  bool changed = true;
  while (changed && points.size() >= 3) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& before = points[(i + points.size() - 1) % points.size()];
      const Vec2& after = points[(i + 1) % points.size()];
      const Vec2 in = points[i] - before, out = after - points[i];
      const bool repeated = in.norm() < 1e-6;
      const bool straight = in.dot(out) > 0 && std::abs(cross(in, out)) < 1e-7 * in.norm() * out.norm();
      if (!repeated && !straight) continue;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      changed = true;
      break;
    }
  }
}

// Where the outline turns by half a circle and runs back over itself; the number of points if it
// does so nowhere.
std::size_t find_fold(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = points[i] - points[(i + n - 1) % n], out = points[(i + 1) % n] - points[i];
    if (in.dot(out) < 0 && std::abs(cross(in, out)) < 1e-7 * in.norm() * out.norm()) return i;
  }
  return n;
}

// How far two boxes are apart at least.
double distance(const Bounds2& a, const Segment& b) {
  const Vec2 below = a.low - b.a.cwiseMax(b.b), above = b.a.cwiseMin(b.b) - a.high;
  return below.cwiseMax(above).cwiseMax(0.0).norm();
}

}  // namespace

bool Polygon::is_convex_corner(std::size_t k) const {
  const Vec2& before = points[(k + points.size() - 1) % points.size()];
  const Vec2& after = points[(k + 1) % points.size()];
  return cross(points[k] - before, after - points[k]) > 0;
}

double signed_area(const std::vector<Vec2>& points) {
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += cross(points[i], points[(i + 1) % points.size()]);
  return 0.5 * twice;
}

double area(const Polygon& polygon) {
  return signed_area(polygon.points);
}

Bounds2 bounds(const Polygon& polygon) {
  Bounds2 result;
  for (const auto& point : polygon.points) result.add(point);
  return result;
}

Result<Polygon> make_polygon(std::vector<Vec2> points) {
  for (const auto& point : points)
    if (!point.allFinite()) return polygon_error("a coordinate is not a finite number");
  drop_needless_points(points);
  if (points.size() < 3) return polygon_error("needs at least three corners that are not in line");
  if (const std::size_t fold = find_fold(points); fold < points.size())
    return polygon_error("has a spike at " + coordinates(points[fold]) + "; leave that corner out");
  const double signed_size = signed_area(points);
  if (signed_size < 0) std::reverse(points.begin(), points.end());

  Polygon polygon{std::move(points)};
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (j == i + 1 || (i == 0 && j == n - 1)) continue;  // neighbours share a corner
      if (intersects(polygon.edge(i), polygon.edge(j)))
        return polygon_error("the edge from " + coordinates(polygon.points[i]) + " crosses the edge from " +
                             coordinates(polygon.points[j]) + "; give the corners in order");
    }
  if (std::abs(signed_size) < 1e-4) return polygon_error("has no area");
  return polygon;
}

bool contains(const Polygon& polygon, const Vec2& point) {
  if (polygon.points.empty()) return false;
  bool inside = false;
  // From the last corner to the first, and so on: asked of every pose, of every wall.
  const Vec2* a = &polygon.points.back();
  for (const Vec2& b : polygon.points) {
    if (passes_right_of(point, *a, b)) inside = !inside;
    a = &b;
  }
  return inside;
}

bool contains(const Polygon& polygon, const Footprint& footprint, double tolerance) {
  // Inside when the centre is and no edge enters the footprint. Of a room's many walls most are far from it.
  if (polygon.points.empty()) return false;
  const Bounds2& box = footprint.bounds();
  const double margin = std::abs(tolerance);
  bool inside = false;
  const Vec2* a = &polygon.points.back();
  for (const Vec2& b : polygon.points) {
    if (passes_right_of(footprint.center(), *a, b)) inside = !inside;
    if (!is_beyond(box, *a, b, margin) && passes_through(footprint, {*a, b}, tolerance)) return false;
    a = &b;
  }
  return inside;
}

double distance_to_boundary(const Polygon& polygon, const Footprint& footprint) {
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (distance(footprint.bounds(), polygon.edge(i)) < best)
      best = std::min(best, gap(footprint, polygon.edge(i)));
  return best;
}

double distance_to_boundary(const Polygon& polygon, const Vec2& point) {
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    best = std::min(best, distance(polygon.edge(i), point));
  return best;
}

std::vector<Vec2> offset_outward(const Polygon& polygon, double distance) {
  std::vector<Vec2> result;
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 before = -polygon.inward((k + n - 1) % n), after = -polygon.inward(k);
    const Vec2 bisector = before + after;
    // Mitre, limited at needle-sharp corners.
    const double scale = std::min(2.0 / std::max(bisector.squaredNorm(), 1e-9), 8.0);
    result.push_back(polygon.points[k] + distance * scale * bisector);
  }
  return result;
}

}  // namespace roomgen
