#include "surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
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

using Ids = std::array<std::uint32_t, 3>;

// Turns faces with corners into triangles between points.
class Assembly {
 public:
  explicit Assembly(std::vector<std::array<Corner, 3>> faces) : faces_(std::move(faces)) {
    weld_points();
    turn_slivers();
    sum_normals();
  }

  Mesh mesh() const {
    Mesh result;
    Vertices vertices(result);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Vec3 face_normal = area_normal(ids_[f]).normalized();
      Triangle triangle{};
      for (int k = 0; k < 3; ++k) {
        const Corner& corner = faces_[f][k];
        const auto id = ids_[f][k];
        Vec3 normal = corner.normal.isZero() ? sums_.at({id, corner.group}) : corner.normal;
        normal.normalize();
        // A fold this sharp is an edge, whoever asked for smoothness.
        if (!(normal.dot(face_normal) > 0.05)) normal = face_normal;
        triangle[k] =
            vertices.add(id, positions_[id], corner.uv.cast<float>(), normal.cast<float>());
      }
      result.triangles.push_back(triangle);
    }
    return result;
  }

 private:
  Vec3 position(std::uint32_t id) const { return positions_[id].cast<double>(); }
  Vec3 area_normal(const Ids& t) const {
    return (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0]));
  }

  void weld_points() {
    Weld weld;
    std::vector<Ids> all;
    for (const auto& face : faces_) {
      auto& ids = all.emplace_back();
      for (int k = 0; k < 3; ++k) ids[k] = weld(face[k].position.cast<float>());
    }
    positions_ = weld.positions();
    Merged merged(positions_.size());
    for (const auto& ids : all)
      for (int k = 0; k < 3; ++k) {
        const auto a = ids[k], b = ids[(k + 1) % 3];
        if (a != b && (positions_[a] - positions_[b]).norm() < shortest_edge) merged.merge(a, b);
      }
    std::vector<std::array<Corner, 3>> kept;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      Ids ids = all[f];
      for (auto& id : ids) id = merged.find(id);
      if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0]) continue;
      kept.push_back(faces_[f]);
      ids_.push_back(ids);
    }
    faces_ = std::move(kept);
  }

  // A triangle without area whose corners differ has one corner on its longest edge. It goes, and
  // its neighbour over that edge is divided at the corner.
  void turn_slivers() {
    std::unordered_map<std::uint64_t, std::size_t> owner;
    const auto remember = [&](std::size_t f) {
      for (int k = 0; k < 3; ++k) owner[directed_edge(ids_[f][k], ids_[f][(k + 1) % 3])] = f;
    };
    bool any = false;
    for (std::size_t f = 0; f < faces_.size(); ++f) any = any || is_sliver(f);
    if (!any) return;
    for (std::size_t f = 0; f < faces_.size(); ++f) remember(f);
    for (int round = 0; round < 4; ++round)
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (!is_sliver(f)) continue;
        const int k = longest_edge(ids_[f]);
        const auto a = ids_[f][k], b = ids_[f][(k + 1) % 3];
        const auto beyond = owner.find(directed_edge(b, a));
        if (beyond == owner.end()) continue;
        const std::size_t other = beyond->second;
        owner.erase(directed_edge(a, b));
        owner.erase(directed_edge(b, a));
        divide(other, f, a, b, ids_[f][(k + 2) % 3]);
        remember(f);
        remember(other);
      }
  }

  bool is_sliver(std::size_t f) const { return area_normal(ids_[f]).norm() < 4e-12; }

  int longest_edge(const Ids& t) const {
    int best = 0;
    for (int k = 1; k < 3; ++k)
      if ((positions_[t[k]] - positions_[t[(k + 1) % 3]]).norm() >
          (positions_[t[best]] - positions_[t[(best + 1) % 3]]).norm())
        best = k;
    return best;
  }

  // Face `other` has the edge from b to a; c lies on it. Its halves become `other` and `free`.
  void divide(std::size_t other, std::size_t free, std::uint32_t a, std::uint32_t b,
              std::uint32_t c) {
    int at_b = 0;
    while (ids_[other][at_b] != b) ++at_b;
    const auto d = ids_[other][(at_b + 2) % 3];
    const Corner cb = faces_[other][at_b], ca = faces_[other][(at_b + 1) % 3],
                 cd = faces_[other][(at_b + 2) % 3];
    const Vec3 way = position(b) - position(a);
    const double t = (position(c) - position(a)).dot(way) / way.squaredNorm();
    Corner cc = ca;
    cc.position = position(c);
    cc.uv = ca.uv + t * (cb.uv - ca.uv);
    cc.normal = ca.normal + t * (cb.normal - ca.normal);
    faces_[other] = {cc, ca, cd};
    ids_[other] = {c, a, d};
    faces_[free] = {cb, cc, cd};
    ids_[free] = {b, c, d};
  }

  // The mean normal of a point within a group: by angle, so that it does not depend on how quads
  // are split, and by area, so that a narrow bevel leaves the flat face beside it flat.
  void sum_normals() {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const auto& t = ids_[f];
        const double angle =
            angle_at(position(t[k]), position(t[(k + 1) % 3]), position(t[(k + 2) % 3]));
        sums_.try_emplace({t[k], faces_[f][k].group}, Vec3::Zero()).first->second +=
            angle * area_normal(t);
      }
  }

  std::vector<std::array<Corner, 3>> faces_;
  std::vector<Ids> ids_;  // as long as faces_
  std::vector<Vec3f> positions_;
  std::map<std::pair<std::uint32_t, int>, Vec3> sums_;
};

}  // namespace

void SurfaceBuilder::triangle(const Corner& a, const Corner& b, const Corner& c) {
  faces_.push_back({a, b, c});
}

void SurfaceBuilder::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
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

Mesh SurfaceBuilder::mesh() const {
  return Assembly(faces_).mesh();
}

}  // namespace roomgen::shape
