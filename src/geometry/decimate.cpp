#include "roomgen/geometry/decimate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace roomgen {

namespace {

// Triangles that became the same one; each starts with its smallest index afterwards.
void drop_repeated(std::vector<Triangle>& triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

Mesh clustered(const Mesh& mesh, const Vec3& low, double cell) {
  const auto key = [&](const Eigen::Vector3f& p) {
    std::uint64_t packed = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto index = static_cast<std::uint64_t>((double{p[axis]} - low[axis]) / cell);
      packed = packed << 21 | (index & 0x1fffff);
    }
    return packed;
  };
  Mesh coarse;
  std::unordered_map<std::uint64_t, std::uint32_t> cluster_of_cell;
  std::vector<std::uint32_t> cluster(mesh.positions.size());
  std::vector<float> members;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto next = static_cast<std::uint32_t>(coarse.positions.size());
    const auto [found, added] = cluster_of_cell.try_emplace(key(mesh.positions[v]), next);
    if (added) {
      coarse.positions.push_back(Eigen::Vector3f::Zero());
      members.push_back(0.0f);
    }
    cluster[v] = found->second;
    coarse.positions[found->second] += mesh.positions[v];
    members[found->second] += 1.0f;
  }
  for (std::size_t c = 0; c < members.size(); ++c) coarse.positions[c] /= members[c];
  for (const auto& t : mesh.triangles)
    coarse.triangles.push_back({cluster[t[0]], cluster[t[1]], cluster[t[2]]});
  drop_repeated(coarse.triangles);
  remove_degenerate(coarse);
  return coarse;
}

}  // namespace

Mesh decimated(const Mesh& mesh, std::size_t max_triangles) {
  if (mesh.triangles.size() <= max_triangles) return mesh;
  const Bounds3 box = bounds(mesh);
  const double extent = std::max(box.size().maxCoeff(), 1e-6);
  // On a surface, n x n cells hold about 2 n^2 triangles.
  double cells = std::sqrt(static_cast<double>(max_triangles));
  Mesh coarse = clustered(mesh, box.low, extent / cells);
  while (coarse.triangles.size() > max_triangles) {  // ends: one cell has no triangles
    cells *= 0.8;
    coarse = clustered(mesh, box.low, extent / cells);
  }
  return coarse;
}

}  // namespace roomgen
