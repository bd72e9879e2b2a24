#pragma once

#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// Does the edge from `a` to `b` cross the line of all points at height `y`?
inline bool crosses_height(double y, const Vec2& a, const Vec2& b) { return (a.y() > y) != (b.y() > y); }

/// Where it does. Precondition: crosses_height.
inline double crossing(double y, const Vec2& a, const Vec2& b) { return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()); }

/// Does the edge from `a` to `b` pass the point's height on its right? A point is inside that has an odd number of them.
inline bool passes_right_of(const Vec2& point, const Vec2& a, const Vec2& b) {
  return crosses_height(point.y(), a, b) && point.x() < crossing(point.y(), a, b);
}

/// Does an edge from `a` to `b` lie wholly on one side of a box, and at least so far from it? Asked of every wall for every pose.
inline bool is_beyond(const Bounds2& box, const Vec2& a, const Vec2& b, double margin) {
  return (a.x() < box.low.x() - margin && b.x() < box.low.x() - margin) || (a.x() > box.high.x() + margin && b.x() > box.high.x() + margin) ||
         (a.y() < box.low.y() - margin && b.y() < box.low.y() - margin) || (a.y() > box.high.y() + margin && b.y() > box.high.y() + margin);
}

/// contains(polygon, point) for many points: what it looks at are the edges near the point's height only.
class Inside {
 public:
  explicit Inside(const Polygon& polygon);
  bool contains(const Vec2& point) const;

 private:
  std::size_t band(double y) const;  ///< precondition: y is within the polygon's box

  double low_ = 0.0, high_ = 0.0;
  double bands_a_metre_ = 0.0;
  std::vector<std::vector<Segment>> bands_;  ///< by height, from below
};

}  // namespace roomgen
