#pragma once

#include <functional>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

/// The solids that shape programs are made of. Metres; a solid given by its sizes stands on z = 0
/// with its box centred on the z axis, like everything else that is placed; one that is drawn (an
/// outline, a profile, a path, levels) stays where it is drawn.
///
/// Each has a function `mesh(solid, tolerance)`: a closed mesh (every edge between exactly two
/// triangles once equal positions are merged), outward normals, smooth where the solid is round and
/// split at its creases, uvs in metres of surface (so that one texture has one scale everywhere),
/// no degenerate triangle. On each piece of surface u runs along its longer side, where the grain
/// of wood runs. `tolerance` is the greatest distance of a chord from the true surface, at least
/// 1e-6.
///
/// Sizes lie between 0.0001 and 1000 m; what is out of range or has no volume is reported as
/// Error::Kind::invalid_input. A bevel counts as the greatest that fits when it is larger.
namespace roomgen::shape {

/// A cuboid with rounded edges of radius `bevel` (0: sharp).
struct Box {
  Vec3 size = Vec3::Ones();
  double bevel = 0.0;

  bool operator==(const Box&) const = default;
};

/// A cylinder, cone (one radius 0) or frustum; `bevel` rounds the rims.
struct Frustum {
  double bottom_radius = 0.5, top_radius = 0.5, height = 1.0;
  double bevel = 0.0;

  bool operator==(const Frustum&) const = default;
};

struct Ellipsoid {
  Vec3 size = Vec3::Ones();

  bool operator==(const Ellipsoid&) const = default;
};

/// A regular prism or pyramid with flat sides; the first side faces the front (-Y). Radii reach the
/// corners.
struct Prism {
  int sides = 6;
  double bottom_radius = 0.5, top_radius = 0.5, height = 1.0;

  bool operator==(const Prism&) const = default;
};

/// A thin slab, closed like everything else.
struct Plane {
  Vec2 size = Vec2::Ones();
  double thickness = 0.002;

  bool operator==(const Plane&) const = default;
};

/// A smooth curve through points: cubic Bezier pieces with automatic handles, as Blender's AUTO; at
/// a point of `corners` (indices) it turns sharply, like Blender's VECTOR handles. Points in Vec3
/// or, for outlines and profiles, Vec2.
template <typename Point>
struct Curve {
  std::vector<Point> points;
  std::vector<std::size_t> corners;
  bool closed = false;

  bool operator==(const Curve&) const = default;
};
/// Straight pieces no further than `tolerance` from the curve, without the first point at the end
/// of a closed one; empty when the curve is none (fewer than two different points, three for closed
/// ones).
std::vector<Vec3> polyline(const Curve<Vec3>& curve, double tolerance);
std::vector<Vec2> polyline(const Curve<Vec2>& curve, double tolerance);
/// The curve with every point a corner: straight pieces.
Curve<Vec2> straight(std::vector<Vec2> points, bool closed);
Curve<Vec3> straight(std::vector<Vec3> points, bool closed);

/// Closed outlines around the origin that need no drawing.
Curve<Vec2> ellipse(const Vec2& size, double tolerance);
/// With corners rounded by the radius `bevel` (0: sharp).
Curve<Vec2> rectangle(const Vec2& size, double bevel, double tolerance);
/// Between a rectangle (`round` 0) and an ellipse (1).
Curve<Vec2> rounded(const Vec2& size, double round, double tolerance);

/// A profile of (radius, z) turned about the z axis. An open profile is closed along the axis; a
/// closed one gives a ring. `angle` below a full turn is closed by flat caps; it opens to the
/// front.
struct Lathe {
  Curve<Vec2> profile;
  double angle = 2 * pi;

  bool operator==(const Lathe&) const = default;
};

/// A closed outline carried along a path without rolling (rotation minimizing frames, Wang et al.
/// 2008). At the end it is `taper` times as large and turned by `twist` radians, linearly between.
/// A closed path gives a ring; it cannot taper and twists by whole turns only. Sharp corners are
/// mitred. The outline's y is up at the start of a level path and to the back at the start of an
/// upright one.
struct Sweep {
  Curve<Vec3> path;
  Curve<Vec2> section;
  double taper = 1.0, twist = 0.0;
};

/// An outline, with holes inside, raised from z = 0; `bevel` rounds the upper and lower edges.
struct Extrusion {
  Curve<Vec2> outline;
  std::vector<Curve<Vec2>> holes;
  double height = 0.02;
  double bevel = 0.0;

  bool operator==(const Extrusion&) const = default;
};

/// A skin over two or more closed outlines at growing heights, resampled to equal numbers of points
/// that begin at the angle nearest to the front; smooth between them unless `straight`.
struct Loft {
  struct Level {
    double z = 0.0;
    Curve<Vec2> outline;
  };
  std::vector<Level> levels;
  bool straight = false;
};

/// The solid under the surface z = height(u, v), u and v in [-1, 1] across the size, down to z = 0.
/// Heights below `least` count as `least`, those above `most` as `most`.
struct HeightField {
  Vec2 size = Vec2::Ones();
  std::function<double(double, double)> height;
  int divisions = 24;  ///< along the longer side, 2 to 128
  double least = 0.002, most = 5.0;
};

/// A leaf lying along +X from the origin, its middle vein bent up by `bend` radians over its length
/// and its halves folded up by `fold` radians: a thin closed solid, widest at `widest` of the
/// length.
struct Leaf {
  double length = 0.2, width = 0.08, thickness = 0.001;
  double bend = 0.0, fold = 0.2, widest = 0.4;

  bool operator==(const Leaf&) const = default;
};

/// A superellipsoid (Barr 1981): `softness` 1 is an ellipsoid, 0.1, the least, almost a box.
/// Stuffed things.
struct Cushion {
  Vec3 size = Vec3::Ones();
  double softness = 0.4;

  bool operator==(const Cushion&) const = default;
};

Result<Mesh> mesh(const Box& solid, double tolerance);
Result<Mesh> mesh(const Frustum& solid, double tolerance);
Result<Mesh> mesh(const Ellipsoid& solid, double tolerance);
Result<Mesh> mesh(const Prism& solid, double tolerance);
Result<Mesh> mesh(const Plane& solid, double tolerance);
Result<Mesh> mesh(const Lathe& solid, double tolerance);
Result<Mesh> mesh(const Sweep& solid, double tolerance);
Result<Mesh> mesh(const Extrusion& solid, double tolerance);
Result<Mesh> mesh(const Loft& solid, double tolerance);
Result<Mesh> mesh(const HeightField& solid, double tolerance);
Result<Mesh> mesh(const Leaf& solid, double tolerance);
Result<Mesh> mesh(const Cushion& solid, double tolerance);

/// The part of a closed mesh on the side of the plane that `normal` points away from, closed again
/// by flat caps (with holes where the cut goes through a hollow). Empty when nothing is left.
Result<Mesh> cut(const Mesh& mesh, const Vec3& point, const Vec3& normal);

/// Is every edge shared by exactly two triangles that run along it in opposite directions, once
/// equal positions are merged?
bool is_closed(const Mesh& mesh);
/// Of a closed mesh, by the divergence theorem; negative when turned inside out.
double volume(const Mesh& mesh);

}  // namespace roomgen::shape
