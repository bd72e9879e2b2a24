#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "roomgen/geometry/vec.h"

namespace roomgen {

using Triangle = std::array<std::uint32_t, 3>;

/// An edge between two vertices as one number; the direction counts.
inline std::uint64_t directed_edge(std::uint32_t from, std::uint32_t to) {
  return std::uint64_t{from} << 32 | to;
}

/// Triangles over shared vertices, counter-clockwise seen from outside. `normals` and `uvs` are empty
/// or as long as `positions`; uv (0, 0) is the top left corner of the image, as in glTF.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Triangle> triangles;
};

struct Bounds3 {
  Vec3 low = Vec3::Constant(1e300);
  Vec3 high = Vec3::Constant(-1e300);

  bool empty() const { return low.x() > high.x(); }
  void add(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vec3 size() const { return high - low; }
  Vec3 center() const { return 0.5 * (low + high); }
};

Bounds3 bounds(const Mesh& mesh);

/// Drops triangles that repeat an index, have an index out of range, a vertex that is not finite, or
/// an area below `min_area` square metres, then drops vertices that nothing uses. Returns how many
/// triangles went.
std::size_t remove_degenerate(Mesh& mesh, double min_area = 1e-12);

/// Fills `normals` where they are missing, of zero length or not finite, with the area-weighted mean
/// of the faces that meet within `crease` radians; vertices are split where a crease needs it.
void repair_normals(Mesh& mesh, double crease = 0.7);

/// Appends `other`, each position p mapped to scale * p + offset (component by component).
void append(Mesh& mesh, const Mesh& other, const Vec3& scale = Vec3::Ones(),
            const Vec3& offset = Vec3::Zero());

/// An axis-aligned box with flat normals and uvs in metres, 24 vertices.
Mesh make_box(const Vec3& low, const Vec3& high);

}  // namespace roomgen
