#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "roomgen/base/result.h"
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

/// An axis-aligned box of the plane.
struct Bounds2 {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);

  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vec2 size() const { return high - low; }
  bool overlaps(const Bounds2& other, double margin = 0.0) const {
    return low.x() < other.high.x() + margin && other.low.x() < high.x() + margin &&
           low.y() < other.high.y() + margin && other.low.y() < high.y() + margin;
  }
};

/// What an object covers of the floor: the rectangle of its box, or the ellipse inscribed in it
/// when the object is round (as a polygon of 24 sides that contains the ellipse and touches the
/// box).
///
/// The local frame is that of objects: width along X, depth along Y, front towards -Y.
class Footprint {
 public:
  Footprint() : Footprint(Vec2::Zero(), Vec2::Zero(), 0.0) {}
  /// `size` is width and depth in metres; `yaw` is counter-clockwise.
  Footprint(const Vec2& center, const Vec2& size, double yaw, bool round = false);

  /// The same elsewhere; cheaper than a new one.
  Footprint moved_to(const Vec2& center) const;

  const Vec2& center() const { return center_; }
  const Vec2& half() const { return half_; }
  double yaw() const { return yaw_; }
  bool round() const { return count_ > 4; }
  Vec2 front() const { return {sin_, -cos_}; }
  /// Unit vectors of the local frame.
  Vec2 x_axis() const { return {cos_, sin_}; }
  Vec2 y_axis() const { return {-sin_, cos_}; }
  Vec2 to_local(const Vec2& point) const;
  Vec2 to_world(const Vec2& local) const;
  /// The outline, counter-clockwise. For a rectangle: back left … in the order (+x,+y), (-x,+y),
  /// (-x,-y), (+x,-y) of the local frame, so corners 0-1 are the back and 2-3 the front.
  std::span<const Vec2> outline() const { return {corners_.data(), count_}; }
  const Bounds2& bounds() const { return bounds_; }
  double area() const;

 private:
  static constexpr std::size_t round_sides = 24;

  Vec2 center_ = Vec2::Zero();
  Vec2 half_ = Vec2::Zero();
  double yaw_ = 0.0;
  double cos_ = 1.0;
  double sin_ = 0.0;
  std::size_t count_ = 4;
  std::array<Vec2, round_sides> corners_;  // the first count_ are set
  Bounds2 bounds_;
};

/// True when the interiors share more than a band of `tolerance` metres (touching is no overlap).
bool overlaps(const Footprint& a, const Footprint& b, double tolerance = 1e-6);
/// Does the segment enter the interior of the footprint shrunk by `margin` metres on all sides?
bool passes_through(const Footprint& footprint, const Segment& segment, double margin = 0.0);
/// Distance between the outlines; 0 when they overlap.
double gap(const Footprint& a, const Footprint& b);
double gap(const Footprint& footprint, const Segment& segment);
/// Distance from a point; 0 inside.
double gap(const Footprint& footprint, const Vec2& point);
bool contains(const Footprint& footprint, const Vec2& point);
/// Half of what it measures along a direction, a unit vector.
double reach_along(const Footprint& footprint, const Vec2& direction);
/// Distance along the ray from `origin` to the footprint, or a negative number if it misses.
double ray_hit(const Footprint& footprint, const Vec2& origin, const Vec2& direction);

/// A simple polygon, counter-clockwise, not repeating its first point. Edge k runs from point k to
/// point k + 1 (the last one back to point 0); the inside is to its left.
struct Polygon {
  std::vector<Vec2> points;

  std::size_t size() const { return points.size(); }
  Segment edge(std::size_t k) const { return {points[k], points[(k + 1) % points.size()]}; }
  /// Unit normal of edge k, towards the inside.
  Vec2 inward(std::size_t k) const { return left_of(edge(k).direction()); }
  /// True where the inner angle at point k is below 180 degrees.
  bool is_convex_corner(std::size_t k) const;
};

/// Positive for counter-clockwise.
double signed_area(const std::vector<Vec2>& points);
double area(const Polygon& polygon);
Bounds2 bounds(const Polygon& polygon);

/// A polygon from points in either winding: repeated points and points in the middle of a straight
/// edge are dropped, the order is made counter-clockwise. Fails when less than a triangle of
/// 1e-4 m2 remains or when edges cross, touch or run
/// back over each other.
Result<Polygon> make_polygon(std::vector<Vec2> points);

bool contains(const Polygon& polygon, const Vec2& point);
/// The whole footprint lies inside; it may touch the boundary, and cross it by `tolerance` metres.
bool contains(const Polygon& polygon, const Footprint& footprint, double tolerance = 1e-3);
/// Distance of the footprint to the nearest edge; 0 when it touches or crosses one.
double distance_to_boundary(const Polygon& polygon, const Footprint& footprint);
double distance_to_boundary(const Polygon& polygon, const Vec2& point);

/// The polygon with every edge moved outward by `distance` (mitred corners): the outer face of walls.
/// Point k corresponds to point k.
std::vector<Vec2> offset_outward(const Polygon& polygon, double distance);

}  // namespace roomgen
