#include "roomgen/collision/solids.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/narrowphase/collision.h>

#include <map>
#include <string>

#include "roomgen/geometry/centroid.h"
#include "roomgen/geometry/decimate.h"

namespace roomgen {

namespace {

constexpr std::size_t max_triangles = 20000;
constexpr double retreat = 0.005;
constexpr std::size_t max_contacts = 200;
constexpr double box_tolerance = 1e-4;

using Tree = fcl::BVHModel<fcl::OBBd>;  // OBB trees take half the memory of OBBRSS ones

// A mesh at the size of the object, with what the tests need.
struct Body {
  Mesh mesh;
  std::shared_ptr<Tree> tree;
  Vec3 centroid = Vec3::Zero();
};

std::shared_ptr<Tree> make_tree(const Mesh& mesh) {
  auto tree = std::make_shared<Tree>();
  tree->beginModel(static_cast<int>(mesh.triangles.size()),
                   static_cast<int>(mesh.positions.size()));
  for (const auto& t : mesh.triangles)
    tree->addTriangle(mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
                      mesh.positions[t[2]].cast<double>());
  tree->endModel();
  return tree;
}

Body make_body(const Mesh& source, const Vec3& scale) {
  Body body;
  append(body.mesh, source, scale);
  body.mesh = decimated(body.mesh, max_triangles);
  if (body.mesh.triangles.empty()) return body;
  body.tree = make_tree(body.mesh);
  body.centroid = surface_centroid(body.mesh);
  return body;
}

fcl::Transform3d transform(const Object& object) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.linear() = Eigen::AngleAxisd(object.yaw, Vec3::UnitZ()).toRotationMatrix();
  result.translation() = object.position;
  return result;
}

// Is the point inside the closed mesh? Counts crossings of a ray upwards, slightly slanted so that it
// meets no edge of axis-aligned meshes.
bool inside(const Mesh& mesh, const Vec3& point) {
  const Vec3 direction = Vec3(0.0123, 0.0071, 1.0).normalized();
  int crossings = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 u = mesh.positions[t[1]].cast<double>() - a;
    const Vec3 v = mesh.positions[t[2]].cast<double>() - a;
    // Moeller and Trumbore 1997.
    const Vec3 p = direction.cross(v);
    const double determinant = u.dot(p);
    if (std::abs(determinant) < 1e-15) continue;
    const Vec3 s = point - a;
    const double alpha = s.dot(p) / determinant;
    const Vec3 q = s.cross(u);
    const double beta = direction.dot(q) / determinant;
    if (alpha < 0 || beta < 0 || alpha + beta > 1 || v.dot(q) / determinant <= 0) continue;
    ++crossings;
  }
  return crossings % 2 == 1;
}

bool contains(const Body& outer, const fcl::Transform3d& outer_pose, const Body& inner,
              const fcl::Transform3d& inner_pose) {
  if (inner.mesh.positions.empty()) return false;
  const Vec3 vertex = inner_pose * inner.mesh.positions.front().cast<double>();
  return inside(outer.mesh, outer_pose.inverse() * vertex);
}

// The pose after a step of 5 mm from the contact towards the body's own centroid.
fcl::Transform3d retreated(const Body& body, fcl::Transform3d pose, const Vec3& contact) {
  const Vec3 away = pose * body.centroid - contact;
  if (away.norm() > 1e-9) pose.translation() += retreat * away.normalized();
  return pose;
}

bool still_collide(const Body& a, const fcl::Transform3d& pose_a, const Body& b,
                   const fcl::Transform3d& pose_b) {
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  fcl::collide(a.tree.get(), pose_a, b.tree.get(), pose_b, request, result);
  return result.isCollision();
}

}  // namespace

struct Solids::Impl {
  const ModelTable& models;
  std::map<std::string, Body> bodies;

  const Body& body(const Object& object) {
    const std::string asset = asset_key(object.asset);
    std::string key = asset;
    for (int axis = 0; axis < 3; ++axis)
      key += "|" + std::to_string(std::lround(object.size[axis] * 1e4));
    const auto found = bodies.find(key);
    if (found != bodies.end()) return found->second;
    const auto model = asset.empty() ? nullptr : models.find(asset);
    Body made;
    if (model && triangle_count(*model) > 0)
      made = make_body(merged_mesh(*model), model_placement(object, bounds(*model)).scale);
    if (!model || made.mesh.triangles.empty()) {
      const Vec3 half(0.5 * object.size.x(), 0.5 * object.size.y(), 0.0);
      made = make_body(make_box(-half, half + Vec3(0, 0, object.size.z())), Vec3::Ones());
    }
    return bodies.emplace(key, std::move(made)).first->second;
  }
};

Solids::Solids(const ModelTable& models) : impl_(std::make_unique<Impl>(Impl{models, {}})) {}
Solids::~Solids() = default;

bool Solids::overlap(const Object& a, const Object& b) {
  if (!both_solid(a, b) || !boxes_overlap(a, b)) return false;
  // Contacts, of which there is a limit, come in another order when the two change places.
  if (b.id < a.id) return overlap(b, a);
  const Body& body_a = impl_->body(a);
  const Body& body_b = impl_->body(b);
  const auto pose_a = transform(a), pose_b = transform(b);

  fcl::CollisionRequestd request(max_contacts, true);
  fcl::CollisionResultd result;
  fcl::collide(body_a.tree.get(), pose_a, body_b.tree.get(), pose_b, request, result);
  if (!result.isCollision())
    return contains(body_a, pose_a, body_b, pose_b) || contains(body_b, pose_b, body_a, pose_a);

  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < result.numContacts(); ++i) mean += result.getContact(i).pos;
  mean /= static_cast<double>(result.numContacts());
  return still_collide(body_a, retreated(body_a, pose_a, mean), body_b, pose_b) &&
         still_collide(body_a, pose_a, body_b, retreated(body_b, pose_b, mean));
}

bool boxes_overlap(const Object& a, const Object& b) {
  if (bottom(a) >= top(b) - box_tolerance || bottom(b) >= top(a) - box_tolerance) return false;
  return overlaps(footprint(a), footprint(b), box_tolerance);
}

bool both_solid(const Object& a, const Object& b) {
  return !a.traits.flat && !b.traits.flat;
}

}  // namespace roomgen
