#include <Eigen/Geometry>
#include <unordered_set>

#include "roomgen/shape/primitives.h"
#include "weld.h"

namespace roomgen::shape {

bool is_closed(const Mesh& mesh) {
  Weld weld;
  std::unordered_set<std::uint64_t> edges;
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto from = weld(mesh.positions[triangle[k]]);
      const auto to = weld(mesh.positions[triangle[(k + 1) % 3]]);
      if (from == to || !edges.insert(directed_edge(from, to)).second) return false;
    }
  for (const auto edge : edges)
    if (!edges.count(edge << 32 | edge >> 32)) return false;
  return true;
}

double volume(const Mesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    six += a.dot(b.cross(c));
  }
  return six / 6.0;
}

}  // namespace roomgen::shape
