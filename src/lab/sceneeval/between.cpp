#include <algorithm>
#include <cmath>

#include "geometric_relations.h"

namespace roomgen::lab {

namespace {

bool is_over(const Vec2& point, const OrientedBox& box) {
  return box.contains({point.x(), point.y(), box.center.z()});
}

bool is_between(const OrientedBox& middle, const OrientedBox& a, const OrientedBox& b) {
  const Vec2 line = (b.center - a.center).head<2>();
  const double length = line.norm();
  if (length <= 0.0) return false;
  const Vec2 along = line / length;
  const Vec2 across = left_of(along);
  const Vec2 at = middle.center.head<2>();
  const Vec2 offset = at - a.center.head<2>();
  const double station = offset.dot(along);
  const double corridor = std::max(a.half_extent(across), b.half_extent(across));
  return station > 0.0 && station < length && !is_over(at, a) && !is_over(at, b) &&
         std::abs(offset.dot(across)) <= corridor + middle.half_extent(across);
}

}  // namespace

double between(const Thing& middle, std::span<const Thing> ends) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_between(middle.box(), ends[i].box(), ends[j].box())) return 1.0;
  return 0.0;
}

}  // namespace roomgen::lab
