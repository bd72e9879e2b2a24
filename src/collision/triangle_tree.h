#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "roomgen/collision/mesh_distance.h"

namespace roomgen::detail {

struct Corners {
  Vec3 a, b, c;
};

Bounds3 box_of(const Corners& triangle);
/// The triangle's nearest point.
Vec3 closest(const Corners& triangle, const Vec3& point);

/// Axis-aligned boxes around the triangles of a mesh. Parts of furniture mostly lie along the axes,
/// and such boxes are made many times faster than turned ones, whose directions take eigenvectors.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh);

  /// Of the surfaces; false, and `nearest` as it was, when they are not nearer than it says. Any
  /// points as near as `enough` will do. The points of triangles that meet are points of them, but
  /// not always common ones.
  bool nearest(const TriangleTree& other, NearestPoints& nearest, double enough = 0.0) const;
  /// Is some triangle so near?
  bool within(const Vec3& point, double distance) const;
  /// Signed crossings of a ray: how many surfaces are around the point.
  int winding(const Vec3& point) const;

 private:
  struct Node {
    Bounds3 box;
    std::uint32_t first = 0,
                  count = 0;  ///< of triangles; none: its halves come at `left` and `right`
    std::uint32_t left = 0, right = 0;
    bool is_leaf() const { return count > 0; }
  };
  class Build;
  class Nearest;

  std::vector<Node> nodes_;  ///< the first is the whole
  std::vector<Corners> triangles_;
};

}  // namespace roomgen::detail
