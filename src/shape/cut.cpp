#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "checks.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/shape/primitives.h"
#include "skin.h"
#include "weld.h"

namespace roomgen::shape {

namespace {

// Points this near count as on the plane, so that no slivers are left along it.
constexpr double plane_thickness = 1e-5;

struct CutPlane {
  Vec3 point, normal;
  double height(const Vec3& p) const { return normal.dot(p - point); }
};

// Cuts the triangles and closes what they leave open.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const CutPlane& plane) : mesh_(mesh), plane_(plane) {
    for (const auto& position : mesh.positions) {
      points_.push_back(weld_(position));
      heights_.push_back(snapped(plane.height(position.cast<double>())));
    }
  }

  Mesh run() {
    for (const auto& triangle : mesh_.triangles) clip(triangle);
    if (mesh_has_area_) close();
    return surface_.mesh();
  }

 private:
  struct Vertex {
    Corner corner;
    std::uint32_t id = 0;  // equal for equal positions
  };

  static double snapped(double height) { return std::abs(height) < plane_thickness ? 0.0 : height; }

  Vertex vertex(std::uint32_t index) {
    Vertex result;
    result.corner.position = mesh_.positions[index].cast<double>();
    if (!mesh_.uvs.empty()) result.corner.uv = mesh_.uvs[index].cast<double>();
    if (!mesh_.normals.empty()) result.corner.normal = mesh_.normals[index].cast<double>();
    result.id = points_[index];
    return result;
  }

  // Where an edge crosses the plane. Its two triangles see the same numbers in the same order.
  Vertex crossing(std::uint32_t a, std::uint32_t b) {
    if (points_[a] > points_[b]) std::swap(a, b);
    const Vertex va = vertex(a), vb = vertex(b);
    const double t = heights_[a] / (heights_[a] - heights_[b]);
    Vertex result;
    const auto between = [t](const auto& p, const auto& q) { return p + t * (q - p); };
    result.corner.position = between(va.corner.position, vb.corner.position);
    result.corner.uv = between(va.corner.uv, vb.corner.uv);
    result.corner.normal = between(va.corner.normal, vb.corner.normal);
    const auto position = result.corner.position.cast<float>();
    result.corner.position = position.cast<double>();
    result.id = weld_(position);
    return result;
  }

  void clip(const Triangle& triangle) {
    std::vector<Vertex> kept;
    bool below = false;
    for (int k = 0; k < 3; ++k) {
      const auto a = triangle[k], b = triangle[(k + 1) % 3];
      below = below || heights_[a] < 0;
      if (heights_[a] <= 0) kept.push_back(vertex(a));
      if (heights_[a] * heights_[b] < 0) kept.push_back(crossing(a, b));
    }
    // What only touches the plane, or lies in it, is left to the cap.
    if (!below) return;
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) add(kept[0], kept[k], kept[k + 1]);
  }

  void add(const Vertex& a, const Vertex& b, const Vertex& c) {
    if (a.id == b.id || b.id == c.id || c.id == a.id) return;
    mesh_has_area_ = true;
    surface_.triangle(a.corner, b.corner, c.corner);
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
      position_[from->id] = from->corner.position;
      // An edge and its opposite cancel.
      if (auto opposite = open_.find({to->id, from->id}); opposite != open_.end()) {
        if (--opposite->second == 0) open_.erase(opposite);
      } else {
        ++open_[{from->id, to->id}];
      }
    }
  }

  // The loops of open edges, run through so that the cap lies on their left as seen from its
  // outside.
  void close() {
    const Vec3 x = plane_.normal.unitOrthogonal(), y = plane_.normal.cross(x);
    std::multimap<std::uint32_t, std::uint32_t> next;
    for (const auto& [edge, count] : open_)
      for (int k = 0; k < count; ++k) next.emplace(edge.second, edge.first);
    std::vector<Loop> loops;
    std::vector<Vec3> points;
    while (!next.empty()) {
      Loop loop;
      for (auto edge = next.begin(); edge != next.end();) {
        const Vec3& p = position_.at(edge->first);
        const Vec3 from_origin = p - plane_.point;
        loop.push_back({from_origin.dot(x), from_origin.dot(y)});
        points.push_back(p);
        const auto to = edge->second;
        next.erase(edge);
        edge = next.find(to);
      }
      loops.push_back(std::move(loop));
    }
    add_cap(surface_, loops, points, plane_.normal);
  }

  const Mesh& mesh_;
  CutPlane plane_;
  Weld weld_;
  std::vector<std::uint32_t> points_;
  std::vector<double> heights_;
  SurfaceBuilder surface_;
  bool mesh_has_area_ = false;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> open_;
  std::unordered_map<std::uint32_t, Vec3> position_;
};

}  // namespace

Result<Mesh> cut(const Mesh& mesh, const Vec3& point, const Vec3& normal) {
  if (!point.allFinite() || !normal.allFinite() || normal.norm() < 1e-9)
    return input_error("cut: the plane needs a point and a direction");
  if (!is_closed(mesh)) return input_error("cut: the mesh is not closed");
  return Cutter(mesh, {point, normal.normalized()}).run();
}

}  // namespace roomgen::shape
