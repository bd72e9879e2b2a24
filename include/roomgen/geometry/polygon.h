#pragma once

#include <cstddef>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/footprint.h"
#include "roomgen/geometry/segment.h"

namespace roomgen {

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
