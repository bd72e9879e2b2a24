#include "decimate.h"

#include <meshoptimizer.h>

#include <limits>
#include <vector>

namespace roomgen {

namespace {

constexpr float most_error = 0.01f;  // of the mesh's extent, while its topology is kept

// Vertices at one place are one: meshes come with a vertex for every normal and uv.
Mesh welded(const Mesh& mesh) {
  constexpr std::size_t stride = sizeof(Eigen::Vector3f);
  const std::size_t count = mesh.positions.size();
  std::vector<unsigned> remap(count);
  const std::size_t places = meshopt_generateVertexRemap(
      remap.data(), nullptr, count, mesh.positions.data(), count, stride);
  Mesh result;
  result.positions.resize(places);
  meshopt_remapVertexBuffer(result.positions.data(), mesh.positions.data(), count, stride,
                            remap.data());
  for (const auto& t : mesh.triangles)
    result.triangles.push_back({remap[t[0]], remap[t[1]], remap[t[2]]});
  return result;
}

}  // namespace

Mesh decimated(const Mesh& mesh, std::size_t max_triangles) {
  if (mesh.triangles.size() <= max_triangles) return mesh;
  Mesh coarse = welded(mesh);
  static_assert(sizeof(Triangle) == 3 * sizeof(unsigned));
  const unsigned* indices = coarse.triangles.front().data();
  const float* positions = coarse.positions.front().data();
  const std::size_t before = 3 * coarse.triangles.size(), most = 3 * max_triangles;
  constexpr std::size_t stride = sizeof(Eigen::Vector3f);
  std::vector<Triangle> kept(coarse.triangles.size());
  unsigned* target = kept.front().data();
  std::size_t count = meshopt_simplify(target, indices, before, positions, coarse.positions.size(),
                                       stride, most, most_error, 0, nullptr);
  // Foliage is loose leaves, which only merge when the surface need not stay whole.
  if (count > most)
    count = meshopt_simplifySloppy(target, indices, before, positions, coarse.positions.size(),
                                   stride, most, std::numeric_limits<float>::max(), nullptr);
  kept.resize(count / 3);
  coarse.triangles = std::move(kept);
  remove_degenerate(coarse);
  return coarse;
}

}  // namespace roomgen
