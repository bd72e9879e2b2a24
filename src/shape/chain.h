#pragma once

#include <string>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/shape/primitives.h"
#include "surface.h"

namespace roomgen::shape {

/// A curve as straight pieces. `crease[i]`: the surface made of it has an edge along point i.
template <typename Point>
struct Chain {
  std::vector<Point> points;
  std::vector<bool> crease;
  bool closed = false;

  std::size_t size() const { return points.size(); }
  /// Closed curves count the piece back to the first point.
  std::size_t pieces() const { return closed ? size() : size() - 1; }
  void add(const Point& point, bool is_crease) {
    points.push_back(point);
    crease.push_back(is_crease);
  }
};
using Chain2 = Chain<Vec2>;
using Chain3 = Chain<Vec3>;

/// Turns sharper than this at a corner are seen as edges.
inline constexpr double crease_angle = 0.45;

/// `max_turn`: no two neighbouring pieces of a smooth part differ by more.
Result<Chain2> sample(const Curve<Vec2>& curve, double tolerance, double max_turn = pi / 4);
Result<Chain3> sample(const Curve<Vec3>& curve, double tolerance, double max_turn = pi / 4);

/// A closed outline without crossings, counter-clockwise. `what` names it in errors.
Result<Chain2> sample_outline(const Curve<Vec2>& outline, double tolerance,
                              const std::string& what);

void reverse(Chain2& chain);

/// The body of a profile of (radius, z) turned by `angle`: a closed profile counter-clockwise in
/// the plane of radius and height, or an open one from the lower to the upper end of the axis, both
/// of its ends on it.
Mesh turned(const Chain2& profile, double angle, double tolerance);

}  // namespace roomgen::shape
