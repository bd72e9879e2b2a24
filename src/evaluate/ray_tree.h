#pragma once

#include <optional>
#include <vector>

#include "roomgen/geometry/mesh.h"

namespace roomgen {

/// Triangles sorted into boxes, for rays and nearest points.
class RayTree {
 public:
  explicit RayTree(const Mesh& mesh);

  /// Distance along the ray to the first triangle, from either side; a triangle at the origin
  /// counts.
  std::optional<double> first_hit(const Vec3& origin, const Vec3& direction) const;
  /// The point of the surface nearest to `point`; precondition: the mesh has triangles.
  Vec3 closest(const Vec3& point) const;

 private:
  struct Corners {
    Vec3 a, b, c;
  };
  struct Node {
    Bounds3 box;
    std::size_t first = 0, count = 0;  ///< triangles of a leaf
    std::size_t right = 0;             ///< the left child follows its parent
  };
  void build(std::size_t first, std::size_t count);

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace roomgen
