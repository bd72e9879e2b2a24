#pragma once

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "roomgen/geometry/polygon.h"

namespace shapes {

using roomgen::Footprint;
using roomgen::Polygon;
using roomgen::Random;
using roomgen::Vec2;

inline Vec2 random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  return {x, random.uniform(low, high)};
}

/// A footprint with sides of 0.1 to 3 m anywhere in a square of 4 m; half of them square to the axes.
inline Footprint random_footprint(Random& random, bool round) {
  const Vec2 center = random_point(random, -2.0, 2.0);
  const Vec2 size = random_point(random, 0.1, 3.0);
  const double yaw =
      random.chance(0.5) ? random.integer(0, 3) * roomgen::pi / 2 : random.uniform(-4.0, 4.0);
  return Footprint(center, size, yaw, round);
}

/// A star-shaped polygon around a point, so never self-intersecting: slanted walls, often not convex.
inline Polygon random_star(Random& random, const Vec2& center, double low, double high, int corners) {
  std::vector<double> angles;
  for (int i = 0; i < corners; ++i)  // one in each sector, so that the centre is inside
    angles.push_back((i + random.uniform(0.1, 0.9)) * 2.0 * roomgen::pi / corners);
  Polygon polygon;
  for (const double angle : angles)
    polygon.points.push_back(center + random.uniform(low, high) *
                                          Vec2(std::cos(angle), std::sin(angle)));
  return polygon;
}

/// Is the point in the polygon? By the winding number: the sum of the angles that the edges subtend.
inline bool winds_around(const std::vector<Vec2>& points, const Vec2& p) {
  double turned = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i] - p, b = points[(i + 1) % points.size()] - p;
    turned += std::atan2(roomgen::cross(a, b), a.dot(b));
  }
  return std::abs(turned) > roomgen::pi;
}

/// Points on the outline and inside of what a footprint really covers: its rectangle, or the ellipse.
/// `rings` x `steps` points, the outermost ring on the rim.
inline std::vector<Vec2> sample(const Footprint& f, int rings, int steps) {
  std::vector<Vec2> points = {f.center()};
  const double c = std::cos(f.yaw()), s = std::sin(f.yaw());
  for (int ring = 1; ring <= rings; ++ring)
    for (int step = 0; step < steps; ++step) {
      const double scale = static_cast<double>(ring) / rings, at = 4.0 * step / steps;
      Vec2 unit;
      if (f.round()) {
        unit = {std::cos(at * roomgen::pi / 2), std::sin(at * roomgen::pi / 2)};
      } else {
        const int side = static_cast<int>(at);
        const double along = 2.0 * (at - side) - 1.0;
        const Vec2 sides[4] = {{1, along}, {-along, 1}, {-1, -along}, {along, -1}};
        unit = sides[side];
      }
      const Vec2 local = scale * unit.cwiseProduct(f.half());
      points.push_back(f.center() + Vec2(c * local.x() - s * local.y(), s * local.x() + c * local.y()));
    }
  return points;
}

}  // namespace shapes
