#include "mesh_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/mesh_tree.h"

namespace roomgen {

namespace {

// One vertex of each surface that hangs together, vertices at one place taken as one.
std::vector<Vec3> surface_points(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  std::map<std::tuple<float, float, float>, std::uint32_t> first;
  for (std::uint32_t k = 0; k < mesh.positions.size(); ++k) {
    const auto& p = mesh.positions[k];
    parent[k] = first.emplace(std::make_tuple(p.x(), p.y(), p.z()), k).first->second;
  }
  for (const auto& t : mesh.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::vector<char> seen(mesh.positions.size(), 0);
  std::vector<Vec3> points;
  for (const auto& t : mesh.triangles)
    if (!std::exchange(seen[root(t[0])], 1)) points.push_back(mesh.positions[t[0]].cast<double>());
  return points;
}

Bounds3 inflated(Bounds3 box, double by) {
  box.low.array() -= by;
  box.high.array() += by;
  return box;
}

bool overlap(const Bounds3& a, const Bounds3& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

struct MeshSolid::Impl {
  Mesh mesh;
  Bounds3 box;

  const MeshTree& tree() const {
    if (!tree_) tree_.emplace(mesh);
    return *tree_;
  }
  const std::vector<Vec3>& surfaces() const {
    if (surfaces_.empty()) surfaces_ = surface_points(mesh);
    return surfaces_;
  }

 private:
  mutable std::optional<MeshTree> tree_;
  mutable std::vector<Vec3> surfaces_;
};

MeshSolid::MeshSolid(Mesh mesh) : impl_(std::make_shared<Impl>()) {
  impl_->box = bounds(mesh);
  impl_->mesh = std::move(mesh);
}

const Mesh& MeshSolid::mesh() const {
  return impl_->mesh;
}

const Bounds3& MeshSolid::box() const {
  return impl_->box;
}

double box_distance(const Bounds3& a, const Bounds3& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero()).norm();
}

bool contains(const MeshSolid& solid, const Vec3& point) {
  const Bounds3& box = solid.box();
  if ((point.array() < box.low.array()).any() || (point.array() > box.high.array()).any())
    return false;
  return solid.impl().tree().around(point).winding > 0;
}

double distance(const MeshSolid& solid, const Vec3& point) {
  if (contains(solid, point)) return 0.0;
  const auto nearest = solid.impl().tree().closest_point(point);
  return nearest ? (*nearest - point).norm() : std::numeric_limits<double>::infinity();
}

namespace {

// A surface of `inner` that lies in `outer`; precondition: no two of their triangles meet.
std::optional<NearestPoints> inside(const MeshSolid& inner, const MeshSolid& outer) {
  if (!overlap(inner.box(), outer.box())) return std::nullopt;
  for (const auto& point : inner.impl().surfaces())
    if (contains(outer, point)) return NearestPoints{0.0, point, point};
  return std::nullopt;
}

}  // namespace

std::optional<NearestPoints> nearest_points(const MeshSolid& a, const MeshSolid& b, double limit) {
  if (a.mesh().triangles.empty() || b.mesh().triangles.empty()) return std::nullopt;
  if (box_distance(a.box(), b.box()) > limit) return std::nullopt;
  // Only what is nearer than this is looked at.
  NearestPoints found;
  found.distance = std::isfinite(limit) ? limit * (1 + 1e-9) + 1e-12 : 1e150;
  const bool near = a.impl().tree().nearest(b.impl().tree(), found);
  if (near && found.distance <= 0.0) return NearestPoints{0.0, found.on_a, found.on_a};
  if (const auto in_b = inside(a, b)) return in_b;
  if (const auto in_a = inside(b, a)) return in_a;
  if (!near || found.distance > limit) return std::nullopt;
  return found;
}

bool within(const MeshSolid& a, const MeshSolid& b, double limit) {
  if (a.mesh().triangles.empty() || b.mesh().triangles.empty()) return false;
  if (box_distance(a.box(), b.box()) > limit) return false;
  NearestPoints found;
  found.distance = limit * (1 + 1e-9) + 1e-12;
  return a.impl().tree().nearest(b.impl().tree(), found, limit) || inside(a, b) || inside(b, a);
}

namespace {

constexpr int samples_across = 48;

// Sums the parts of a triangle that are near a solid, by halving until they are small.
class AreaNear {
 public:
  AreaNear(const MeshSolid& solid, const Bounds3& region, double near, double pitch)
      : solid_(solid), near_(near), pitch_(pitch), region_(region) {}

  void add(const Facet& t, double enough) {
    if (area_ >= enough || !overlap(bounds(t), region_)) return;
    const double ab = (t.b - t.a).squaredNorm(), bc = (t.c - t.b).squaredNorm(),
                 ca = (t.a - t.c).squaredNorm();
    const double longest = std::max({ab, bc, ca});
    if (longest <= pitch_ * pitch_) {
      if (is_near((t.a + t.b + t.c) / 3.0)) area_ += 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
      return;
    }
    if (longest == ab) return halve(t.a, t.b, t.c, enough);
    if (longest == bc) return halve(t.b, t.c, t.a, enough);
    halve(t.c, t.a, t.b, enough);
  }

  double area() const { return area_; }

 private:
  void halve(const Vec3& from, const Vec3& to, const Vec3& across, double enough) {
    const Vec3 middle = 0.5 * (from + to);
    add({from, middle, across}, enough);
    add({middle, to, across}, enough);
  }

  bool is_near(const Vec3& point) const {
    return solid_.impl().tree().within(point, near_) || contains(solid_, point);
  }

  const MeshSolid& solid_;
  double near_, pitch_;
  Bounds3 region_;
  double area_ = 0.0;
};

}  // namespace

double contact_area(const MeshSolid& a, const MeshSolid& b, double near,
                    const AreaOptions& options) {
  const Bounds3 reach = inflated(b.box(), near);
  const Bounds3 region = {a.box().low.cwiseMax(reach.low).cwiseMax(options.within.low),
                          a.box().high.cwiseMin(reach.high).cwiseMin(options.within.high)};
  if ((region.low.array() > region.high.array()).any()) return 0.0;
  const double pitch = std::max(0.3 * near, region.size().maxCoeff() / samples_across);
  AreaNear sum(b, region, near, pitch);
  for (const auto& t : a.mesh().triangles) sum.add(facet(a.mesh(), t), options.enough);
  return sum.area();
}

}  // namespace roomgen
