#include "roomgen/geometry/polygon.h"

#include <algorithm>

namespace roomgen {

Vec2 closest_point(const Segment& segment, const Vec2& point) {
  const Vec2 along = segment.b - segment.a;
  const double squared = along.squaredNorm();
  if (squared == 0.0) return segment.a;
  const double t = std::clamp((point - segment.a).dot(along) / squared, 0.0, 1.0);
  return segment.a + t * along;
}

double distance(const Segment& segment, const Vec2& point) {
  return (closest_point(segment, point) - point).norm();
}

bool intersects(const Segment& s, const Segment& t) {
  const double a = cross(s.b - s.a, t.a - s.a), b = cross(s.b - s.a, t.b - s.a);
  const double c = cross(t.b - t.a, s.a - t.a), d = cross(t.b - t.a, s.b - t.a);
  if (((a > 0) != (b > 0)) && ((c > 0) != (d > 0)) && a != 0 && b != 0 && c != 0 && d != 0)
    return true;
  // An end of one that lies on the other, parallel ones included.
  constexpr double touching = 1e-12;
  return distance(s, t.a) < touching || distance(s, t.b) < touching ||
         distance(t, s.a) < touching || distance(t, s.b) < touching;
}

double distance(const Segment& s, const Segment& t) {
  if (intersects(s, t)) return 0.0;
  return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
}

}  // namespace roomgen
