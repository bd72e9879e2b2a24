#include "roomgen/collision/mesh_distance.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/distance.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace roomgen {

namespace {

// FCL measures distances with swept rectangles; its OBB trees only tell whether things meet.
using Tree = fcl::BVHModel<fcl::OBBRSSd>;

struct Corners {
  Vec3 a, b, c;
};

Corners corners(const Mesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
          mesh.positions[t[2]].cast<double>()};
}

std::shared_ptr<Tree> make_tree(const Mesh& mesh) {
  auto tree = std::make_shared<Tree>();
  tree->beginModel(static_cast<int>(mesh.triangles.size()),
                   static_cast<int>(3 * mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    const Corners at = corners(mesh, t);
    tree->addTriangle(at.a, at.b, at.c);
  }
  tree->endModel();
  return tree;
}

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

Bounds3 box_of(const Corners& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

// Ericson, Real-Time Collision Detection, 5.1.5.
Vec3 closest(const Corners& t, const Vec3& p) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t.a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t.a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return t.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b);
  const double sum = va + vb + vc;
  return sum > 0 ? Vec3(t.a + (vb * ab + vc * ac) / sum) : t.a;
}

// Signed crossings of a ray: how many surfaces are around the point. Upwards, slightly slanted so
// that it meets no edge of axis-aligned meshes (Moeller and Trumbore 1997).
int winding(const Mesh& mesh, const Vec3& point) {
  static const Vec3 direction = Vec3(0.0123, 0.0071, 1.0).normalized();
  int around = 0;
  for (const auto& triangle : mesh.triangles) {
    const Corners t = corners(mesh, triangle);
    const Vec3 u = t.b - t.a, v = t.c - t.a;
    const Vec3 p = direction.cross(v);
    const double determinant = u.dot(p);
    if (std::abs(determinant) < 1e-15) continue;
    const Vec3 s = point - t.a;
    const double alpha = s.dot(p) / determinant;
    if (alpha < 0 || alpha > 1) continue;
    const Vec3 q = s.cross(u);
    const double beta = direction.dot(q) / determinant;
    if (beta < 0 || alpha + beta > 1 || v.dot(q) / determinant <= 0) continue;
    around += determinant < 0 ? 1 : -1;
  }
  return around;
}

}  // namespace

struct MeshSolid::Impl {
  Mesh mesh;
  Bounds3 box;

  const Tree& tree() const {
    if (!tree_) tree_ = make_tree(mesh);
    return *tree_;
  }
  const std::vector<Vec3>& surfaces() const {
    if (surfaces_.empty()) surfaces_ = surface_points(mesh);
    return surfaces_;
  }

 private:
  mutable std::shared_ptr<Tree> tree_;
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
  return winding(solid.mesh(), point) > 0;
}

double distance(const MeshSolid& solid, const Vec3& point) {
  if (contains(solid, point)) return 0.0;
  double best = std::numeric_limits<double>::infinity();
  for (const auto& t : solid.mesh().triangles)
    best = std::min(best, (closest(corners(solid.mesh(), t), point) - point).squaredNorm());
  return std::sqrt(best);
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
  const fcl::DistanceRequestd request(true);
  // Only what is nearer than this is looked at.
  fcl::DistanceResultd found(std::isfinite(limit) ? limit * (1 + 1e-9) + 1e-12
                                                  : std::numeric_limits<double>::max());
  fcl::distance(&a.impl().tree(), fcl::Transform3d::Identity(), &b.impl().tree(),
                fcl::Transform3d::Identity(), request, found);
  const bool near = found.b1 != fcl::DistanceResultd::NONE;
  if (near && found.min_distance <= 0.0)
    return NearestPoints{0.0, found.nearest_points[0], found.nearest_points[0]};
  if (const auto in_b = inside(a, b)) return in_b;
  if (const auto in_a = inside(b, a)) return in_a;
  if (!near || found.min_distance > limit) return std::nullopt;
  return NearestPoints{found.min_distance, found.nearest_points[0], found.nearest_points[1]};
}

namespace {

constexpr int samples_across = 48;

// Sums the parts of a triangle that are near a solid, by halving until they are small.
class AreaNear {
 public:
  AreaNear(const MeshSolid& solid, const Bounds3& region, double near, double pitch)
      : solid_(solid), near_(near), pitch_(pitch), region_(region) {
    const Bounds3 around = inflated(region, near);
    for (const auto& t : solid.mesh().triangles) {
      const Corners at = corners(solid.mesh(), t);
      if (overlap(box_of(at), around)) close_.push_back(at);
    }
  }

  void add(const Corners& t, double enough) {
    if (area_ >= enough || !overlap(box_of(t), region_)) return;
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
    for (const auto& t : close_)
      if ((closest(t, point) - point).squaredNorm() <= near_ * near_) return true;
    return contains(solid_, point);
  }

  const MeshSolid& solid_;
  double near_, pitch_;
  Bounds3 region_;
  std::vector<Corners> close_;
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
  for (const auto& t : a.mesh().triangles) sum.add(corners(a.mesh(), t), options.enough);
  return sum.area();
}

}  // namespace roomgen
