#pragma once

#include <array>
#include <vector>

#include "roomgen/geometry/model.h"

namespace roomgen::shape {

/// A corner of a triangle under construction. A zero normal asks for the mean over the corners of
/// the same group at that position: one group is shaded smoothly, two meet in a crease.
struct Corner {
  Vec3 position = Vec3::Zero();
  Vec2 uv = Vec2::Zero();
  Vec3 normal = Vec3::Zero();
  int group = 0;
};

/// Collects triangles by their corners' values and makes a mesh of them. Corners at one position
/// are one point of the surface, however many pieces meet there: a body is closed when its pieces
/// compute their common positions from the same numbers.
class SurfaceBuilder {
 public:
  void triangle(const Corner& a, const Corner& b, const Corner& c);
  /// Split along the shorter diagonal.
  void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);
  /// Points less than two micrometres apart along an edge become one, which takes the triangles
  /// without area away and keeps the surface closed.
  Mesh mesh() const;

 private:
  using Face = std::array<Corner, 3>;
  std::vector<Face> faces_;
};

/// The coordinates on a piece of surface that runs `right` and `up` as seen from outside. When it
/// is `upright`, longer up than across, u runs up: grain painted along u follows the longer side.
inline Vec2 surface_uv(double right, double up, bool upright) {
  return upright ? Vec2(up, right) : Vec2(right, -up);
}

}  // namespace roomgen::shape
