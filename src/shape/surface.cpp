#include "surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "weld.h"

namespace roomgen::shape {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr float shortest_edge = 2e-6f;

// Which point stands for each point once those at the ends of very short edges are one.
class Merged {
 public:
  explicit Merged(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t point) {
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }
  void merge(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

double angle_at(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex, v = b - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// A vertex of the mesh is a point with its uv and its normal.
class Vertices {
 public:
  explicit Vertices(Mesh& mesh) : mesh_(mesh) {}
  std::uint32_t add(std::uint32_t point, const Vec3f& position, const Eigen::Vector2f& uv,
                    const Vec3f& normal) {
    const auto key = std::make_tuple(point, uv.x(), uv.y(), normal.x(), normal.y(), normal.z());
    const auto [place, is_new] =
        known_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      mesh_.positions.push_back(position);
      mesh_.uvs.push_back(uv);
      mesh_.normals.push_back(normal);
    }
    return place->second;
  }

 private:
  Mesh& mesh_;
  std::map<std::tuple<std::uint32_t, float, float, float, float, float>, std::uint32_t> known_;
};

}  // namespace

void Surface::triangle(const Corner& a, const Corner& b, const Corner& c) {
  faces_.push_back({a, b, c});
}

void Surface::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double first = (c.position - a.position).squaredNorm();
  const double second = (d.position - b.position).squaredNorm();
  if (first <= second * (1.0 + 1e-9)) {
    triangle(a, b, c);
    triangle(a, c, d);
  } else {
    triangle(a, b, d);
    triangle(b, c, d);
  }
}

Mesh Surface::mesh() const {
  Weld weld;
  std::vector<std::array<std::uint32_t, 3>> points;
  for (const auto& face : faces_) {
    auto& ids = points.emplace_back();
    for (int k = 0; k < 3; ++k) ids[k] = weld(face[k].position.cast<float>());
  }
  Merged merged(weld.positions().size());
  for (const auto& ids : points)
    for (int k = 0; k < 3; ++k) {
      const auto a = ids[k], b = ids[(k + 1) % 3];
      if (a != b && (weld.positions()[a] - weld.positions()[b]).norm() < shortest_edge)
        merged.merge(a, b);
    }

  // The mean normal of a point within a group: by angle, so that it does not depend on how quads
  // are split, and by area, so that a narrow bevel leaves the flat face beside it flat.
  std::map<std::pair<std::uint32_t, int>, Vec3> sums;
  std::vector<std::size_t> kept;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    auto& ids = points[f];
    for (auto& id : ids) id = merged.find(id);
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0]) continue;
    kept.push_back(f);
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = weld.positions()[ids[k]].cast<double>();
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    for (int k = 0; k < 3; ++k)
      sums.try_emplace({ids[k], faces_[f][k].group}, Vec3::Zero()).first->second +=
          angle_at(p[k], p[(k + 1) % 3], p[(k + 2) % 3]) * normal;
  }

  Mesh result;
  Vertices vertices(result);
  for (const auto f : kept) {
    const auto& face = faces_[f];
    Triangle indices{};
    for (int k = 0; k < 3; ++k) {
      const auto& corner = face[k];
      const auto point = points[f][k];
      const Vec3 normal = corner.normal.isZero() ? sums.at({point, corner.group}) : corner.normal;
      indices[k] = vertices.add(point, weld.positions()[point], corner.uv.cast<float>(),
                                normal.normalized().cast<float>());
    }
    result.triangles.push_back(indices);
  }
  return result;
}

}  // namespace roomgen::shape
