#include "convex_hull.h"

#include <algorithm>
#include <limits>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

namespace {

// One side of the hull of sorted points, without its last one.
template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<Vec2>& hull) {
  const std::size_t start = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= start + 2 &&
           cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(*first);
  }
  hull.pop_back();
}

}  // namespace

// Andrew 1979, the monotone chain.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  add_chain(points.begin(), points.end(), hull);
  add_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

double depth_in(const std::vector<Vec2>& hull, const Vec2& point) {
  if (hull.empty()) return -1.0;
  bool inside = hull.size() >= 3;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Segment side{hull[k], hull[(k + 1) % hull.size()]};
    inside = inside && cross(side.b - side.a, point - side.a) >= 0;
    nearest = std::min(nearest, distance(side, point));
  }
  return inside ? nearest : -nearest;
}

}  // namespace roomgen
