#include "roomgen/geometry/model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>

namespace roomgen {

namespace {

using Vec3f = Eigen::Vector3f;

Vec3f area_normal(const Mesh& mesh, const Triangle& t) {
  return 0.5f * (mesh.positions[t[1]] - mesh.positions[t[0]])
                    .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
}

// Vertices of unused indices go; the order of the others stays.
void drop_unused_vertices(Mesh& mesh) {
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(mesh.positions.size(), unused);
  for (const auto& t : mesh.triangles)
    for (auto v : t) new_index[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == unused) continue;
    mesh.positions[kept] = mesh.positions[v];
    if (!mesh.normals.empty()) mesh.normals[kept] = mesh.normals[v];
    if (!mesh.uvs.empty()) mesh.uvs[kept] = mesh.uvs[v];
    new_index[v] = kept++;
  }
  mesh.positions.resize(kept);
  if (!mesh.normals.empty()) mesh.normals.resize(kept);
  if (!mesh.uvs.empty()) mesh.uvs.resize(kept);
  for (auto& t : mesh.triangles)
    for (auto& v : t) v = new_index[v];
}

bool is_unit(const Vec3f& n) {
  return n.allFinite() && std::abs(n.squaredNorm() - 1.0f) < 1e-3f;
}

// Vertices at the same point count as one.
std::vector<std::uint32_t> weld(const Mesh& mesh) {
  const auto& at = mesh.positions;
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    for (int axis = 0; axis < 3;
         ++axis)  // no zero is below another; what is no number has its place, too
      if (const auto order = std::strong_order(at[a][axis] + 0.0f, at[b][axis] + 0.0f); order != 0)
        return order < 0;
    return a < b;
  };
  std::vector<std::uint32_t> sorted(at.size()), group(at.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), before);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    group[sorted[i]] =
        i > 0 && at[sorted[i]] == at[sorted[i - 1]] ? group[sorted[i - 1]] : sorted[i];
  return group;
}

}  // namespace

Bounds3 bounds(const Mesh& mesh) {
  Bounds3 result;
  for (const auto& position : mesh.positions) result.add(position.cast<double>());
  return result;
}

std::size_t remove_degenerate(Mesh& mesh, double min_area) {
  const auto is_bad = [&](const Triangle& t) {
    for (auto v : t)
      if (v >= mesh.positions.size() || !mesh.positions[v].allFinite()) return true;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    return !(area_normal(mesh, t).norm() >= min_area);
  };
  const auto before = mesh.triangles.size();
  std::erase_if(mesh.triangles, is_bad);
  if (mesh.normals.size() != mesh.positions.size()) mesh.normals.clear();
  if (mesh.uvs.size() != mesh.positions.size()) mesh.uvs.clear();
  drop_unused_vertices(mesh);
  return before - mesh.triangles.size();
}

void repair_normals(Mesh& mesh, double crease) {
  if (mesh.normals.size() == mesh.positions.size()) {
    // Renormalise what is nearly right; nothing else to do if that mends all.
    bool all_good = true;
    for (auto& n : mesh.normals) {
      if (n.allFinite() && n.norm() > 1e-6f) n.normalize();
      all_good = all_good && is_unit(n);
    }
    if (all_good) return;
  } else {
    mesh.normals.assign(mesh.positions.size(), Vec3f::Zero());
  }

  const auto group = weld(mesh);
  std::vector<std::vector<std::uint32_t>> faces_of_group(mesh.positions.size());
  std::vector<Vec3f> face_normals, unit_normals;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    face_normals.push_back(area_normal(mesh, mesh.triangles[f]));
    unit_normals.push_back(face_normals.back().normalized());
    for (auto v : mesh.triangles[f]) faces_of_group[group[v]].push_back(f);
  }
  const float min_cosine = static_cast<float>(std::cos(crease));

  // The normal of a corner is the mean over the faces at that point that turn away by less than the
  // crease. A vertex whose corners disagree is split.
  std::vector<bool> assigned(mesh.positions.size(), false);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3f own = unit_normals[f];
    for (auto& v : mesh.triangles[f]) {
      if (is_unit(mesh.normals[v]) && !assigned[v]) continue;
      Vec3f sum = Vec3f::Zero();
      for (auto other : faces_of_group[group[v]])
        if (unit_normals[other].dot(own) >= min_cosine) sum += face_normals[other];
      const Vec3f normal = sum.norm() > 0 ? Vec3f(sum.normalized()) : own;
      if (!assigned[v]) {
        mesh.normals[v] = normal;
        assigned[v] = true;
      } else if ((mesh.normals[v] - normal).norm() > 1e-3f) {
        const Vec3f position = mesh.positions[v];
        mesh.positions.push_back(position);
        mesh.normals.push_back(normal);
        if (!mesh.uvs.empty()) {
          const Eigen::Vector2f uv = mesh.uvs[v];
          mesh.uvs.push_back(uv);
        }
        v = static_cast<std::uint32_t>(mesh.positions.size() - 1);
      }
    }
  }
}

void append(Mesh& mesh, const Mesh& other, const Vec3& scale, const Vec3& offset) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& p : other.positions)
    mesh.positions.push_back((p.cast<double>().cwiseProduct(scale) + offset).cast<float>());
  for (const auto& n : other.normals)
    mesh.normals.push_back(n.cast<double>().cwiseQuotient(scale).normalized().cast<float>());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Mesh make_box(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      Vec3 normal = Vec3::Zero();
      normal[axis] = side ? 1.0 : -1.0;
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (int corner = 0; corner < 4; ++corner) {
        const bool at_u = corner == 1 || corner == 2, at_v = corner >= 2;
        Vec3 p;
        p[axis] = side ? high[axis] : low[axis];
        p[u] = at_u ? high[u] : low[u];
        p[v] = at_v ? high[v] : low[v];
        mesh.positions.push_back(p.cast<float>());
        mesh.normals.push_back(normal.cast<float>());
        mesh.uvs.push_back({static_cast<float>(p[u] - low[u]), static_cast<float>(p[v] - low[v])});
      }
      // (axis, u, v) is right-handed: counter-clockwise in (u, v) faces +axis.
      if (side) {
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
      } else {
        mesh.triangles.push_back({first, first + 2, first + 1});
        mesh.triangles.push_back({first, first + 3, first + 2});
      }
    }
  }
  return mesh;
}

}  // namespace roomgen
