#pragma once

#include <vector>

#include "roomgen/geometry/vec.h"
#include "roomgen/scene/object.h"

namespace roomgen::lab {

/// A side of a box in its own frame, as SceneEval names them: the front is -Y, and left is -X, which
/// is the left of who looks at the front (roomgen's own relations mean the sitter's left, +X).
enum class BoxSide { left, right, front, back, top, bottom };

/// A box turned about the vertical.
struct OrientedBox {
  Vec3 center = Vec3::Zero();
  Vec3 half = Vec3::Zero();
  double yaw = 0.0;

  Vec3 to_local(const Vec3& point) const;
  Vec3 to_world(const Vec3& local) const;
  Vec3 front() const;
  double volume() const;
  /// How far the box reaches from its centre along a horizontal direction of length 1.
  double half_extent(const Vec2& direction) const;
  bool contains(const Vec3& point) const;
  /// Is the point on that side: beyond the face (`outside`) or at least beyond the middle, and
  /// beside the face, which counts as larger by the share `margin`?
  bool at_side(const Vec3& point, BoxSide side, bool outside, double margin) const;
  /// Points that fill the box evenly: the middles of n x n x n cells. SceneEval draws them by
  /// chance, so that its figures vary from run to run around these.
  std::vector<Vec3> points(int n = 10) const;
};

OrientedBox box_of(const Object& object);

}  // namespace roomgen::lab
