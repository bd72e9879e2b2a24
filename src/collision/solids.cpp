#include "solids.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/narrowphase/collision.h>

#include <map>
#include <string>

#include "geometry/centroid.h"
#include "geometry/decimate.h"
#include "geometry/mesh_tree.h"
#include "sized_mesh.h"

namespace roomgen {

namespace {

constexpr std::size_t max_triangles = 20000;
constexpr double retreat = 0.005;
constexpr std::size_t max_contacts = 100000;  // more than meshes of that size have
constexpr double box_tolerance = 1e-4;

using CollisionTree = fcl::BVHModel<fcl::OBBd>;  // OBB trees take half the memory of OBBRSS ones
using Pose3 = fcl::Transform3d;

CollisionTree collision_tree(const Mesh& mesh) {
  CollisionTree tree;
  tree.beginModel(static_cast<int>(mesh.triangles.size()),
                  static_cast<int>(mesh.positions.size()));
  for (const auto& t : mesh.triangles) {
    const Facet corners = facet(mesh, t);
    tree.addTriangle(corners.a, corners.b, corners.c);
  }
  tree.endModel();
  return tree;
}

// A mesh at the size of the object, with what the tests need.
class Body {
 public:
  explicit Body(Mesh mesh)
      : mesh_(std::move(mesh)), tree_(collision_tree(mesh_)), centroid_(surface_centroid(mesh_)) {}

  const CollisionTree* tree() const { return &tree_; }
  const Vec3& centroid() const { return centroid_; }
  Vec3 some_vertex() const { return mesh_.positions.front().cast<double>(); }

  /// Furniture is wound as its maker liked: an odd number of surfaces around the point counts.
  bool encloses(const Vec3& point) {
    if (!surfaces_) surfaces_ = std::make_unique<MeshTree>(mesh_);
    return surfaces_->around(point).crossings % 2 == 1;
  }

 private:
  Mesh mesh_;
  CollisionTree tree_;
  Vec3 centroid_;
  std::unique_ptr<MeshTree> surfaces_;  // made when first asked for
};

struct PlacedBody {
  Body& body;
  Pose3 pose;
};

bool contains(const PlacedBody& outer, const PlacedBody& inner) {
  return outer.body.encloses(outer.pose.inverse() * (inner.pose * inner.body.some_vertex()));
}

fcl::CollisionResultd contacts_of(const PlacedBody& a, const PlacedBody& b, std::size_t most) {
  fcl::CollisionResultd result;
  fcl::collide(a.body.tree(), a.pose, b.body.tree(), b.pose,
               fcl::CollisionRequestd(most, most > 1), result);
  return result;
}

// After a step of 5 mm from the contact towards the body's own centroid.
PlacedBody retreated(PlacedBody placed, const Vec3& contact) {
  const Vec3 away = placed.pose * placed.body.centroid() - contact;
  if (away.norm() > 1e-9) placed.pose.translation() += retreat * away.normalized();
  return placed;
}

bool collide(const PlacedBody& a, const PlacedBody& b) {
  return contacts_of(a, b, 1).isCollision();
}

Vec3 mean_contact(const fcl::CollisionResultd& result) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < result.numContacts(); ++i) sum += result.getContact(i).pos;
  return sum / static_cast<double>(result.numContacts());
}

}  // namespace

struct Solids::Impl {
  const ModelTable& models;
  std::map<std::string, Body> bodies;

  PlacedBody placed(const Object& object) {
    Pose3 pose = Pose3::Identity();
    pose.linear() = Eigen::AngleAxisd(object.yaw, Vec3::UnitZ()).toRotationMatrix();
    pose.translation() = object.position;
    return {body(object), pose};
  }

  Body& body(const Object& object) {
    std::string key = detail::sized_key(object, models);
    if (const auto known = bodies.find(key); known != bodies.end()) return known->second;
    Mesh mesh = decimated(detail::sized_mesh(object, models), max_triangles);
    return bodies.try_emplace(std::move(key), std::move(mesh)).first->second;
  }
};

Solids::Solids(const ModelTable& models) : impl_(std::make_unique<Impl>(Impl{models, {}})) {}
Solids::~Solids() = default;

bool Solids::overlap(const Object& a, const Object& b) {
  return both_solid(a, b) && intersect(a, b);
}

bool Solids::intersect(const Object& a, const Object& b) {
  if (!boxes_overlap(a, b)) return false;
  // Sums of contacts are not the same to the last digit when the two change places.
  if (b.id < a.id) return intersect(b, a);
  const PlacedBody first = impl_->placed(a), second = impl_->placed(b);
  const auto contacts = contacts_of(first, second, max_contacts);
  if (!contacts.isCollision()) return contains(first, second) || contains(second, first);
  const Vec3 mean = mean_contact(contacts);
  return collide(retreated(first, mean), second) && collide(first, retreated(second, mean));
}

bool boxes_overlap(const Object& a, const Object& b) {
  if (bottom(a) >= top(b) - box_tolerance || bottom(b) >= top(a) - box_tolerance) return false;
  const double reach = 0.5 * (a.size.head<2>().norm() + b.size.head<2>().norm());
  if ((a.position - b.position).head<2>().squaredNorm() > reach * reach) return false;
  const auto rectangle = [](const Object& object) {
    return Footprint(object.position.head<2>(), object.size.head<2>(), object.yaw);
  };
  return overlaps(rectangle(a), rectangle(b), box_tolerance);
}

bool both_solid(const Object& a, const Object& b) {
  return !a.traits.flat && !b.traits.flat;
}

}  // namespace roomgen
