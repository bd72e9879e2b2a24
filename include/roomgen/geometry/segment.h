#pragma once

#include "roomgen/geometry/vec.h"

namespace roomgen {

struct Segment {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();

  double length() const { return (b - a).norm(); }
  Vec2 middle() const { return 0.5 * (a + b); }
  /// Unit vector from a to b; precondition: length() > 0.
  Vec2 direction() const { return (b - a) / length(); }
};

Vec2 closest_point(const Segment& segment, const Vec2& point);
double distance(const Segment& segment, const Vec2& point);
/// 0 when they cross or touch.
double distance(const Segment& s, const Segment& t);
/// True when they share a point, ends included.
bool intersects(const Segment& s, const Segment& t);

}  // namespace roomgen
