#include "solids.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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
// Of what is remembered: far below what files hold of a pose.
constexpr double length_step = 1e-6;  // metres
constexpr double turn_step = 1e-7;    // radians
constexpr std::size_t most_meetings = 200000;

using CollisionTree = fcl::BVHModel<fcl::OBBd>;  // OBB trees take half the memory of OBBRSS ones
using Pose3 = fcl::Transform3d;

// Parts of furniture mostly lie along the axes: boxes along them fit as well as turned ones, whose
// directions take eigenvectors, and are made many times faster.
class BoxesAlongAxes final : public fcl::detail::BVFitterBase<fcl::OBBd> {
 public:
  void set(Vec3* vertices, fcl::Triangle* triangles, fcl::BVHModelType) override {
    vertices_ = vertices, triangles_ = triangles;
  }
  void set(Vec3* vertices, Vec3*, fcl::Triangle* triangles, fcl::BVHModelType type) override {
    set(vertices, triangles, type);
  }
  void clear() override { vertices_ = nullptr, triangles_ = nullptr; }

  fcl::OBBd fit(unsigned int* numbers, int count) override {
    Bounds3 box;
    for (int i = 0; i < count; ++i)
      for (int corner = 0; corner < 3; ++corner)
        box.add(vertices_[triangles_[numbers[i]][corner]]);
    // The longest side first: across it the box is halved.
    const Vec3 half = 0.5 * box.size();
    int longest = 0;
    half.maxCoeff(&longest);
    fcl::Matrix3d axes;
    Vec3 extent;
    for (int k = 0; k < 3; ++k) {
      axes.col(k) = Vec3::Unit((longest + k) % 3);
      extent[k] = half[(longest + k) % 3];
    }
    return {axes, box.center(), extent};
  }

 private:
  const Vec3* vertices_ = nullptr;
  const fcl::Triangle* triangles_ = nullptr;
};

CollisionTree collision_tree(const Mesh& mesh) {
  CollisionTree tree;
  tree.bv_fitter = std::make_shared<BoxesAlongAxes>();
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

// How one thing stands to another, in steps: x, y, z and turn in the frame of the other.
using Stance = std::array<std::int64_t, 4>;

Stance stance(const Object& of, const Object& to) {
  const Vec3 apart = of.position - to.position;
  const Vec2 local = rotated(Vec2(apart.head<2>()), -to.yaw);
  return {std::llround(local.x() / length_step), std::llround(local.y() / length_step),
          std::llround(apart.z() / length_step),
          std::llround(wrap_angle(of.yaw - to.yaw) / turn_step)};
}

Pose3 pose_of(const Stance& stance) {
  Pose3 pose = Pose3::Identity();
  pose.linear() = Eigen::AngleAxisd(turn_step * static_cast<double>(stance[3]), Vec3::UnitZ())
                      .toRotationMatrix();
  for (int axis = 0; axis < 3; ++axis)
    pose.translation()[axis] = length_step * static_cast<double>(stance[static_cast<std::size_t>(axis)]);
  return pose;
}

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

bool share_space(const PlacedBody& a, const PlacedBody& b) {
  const auto contacts = contacts_of(a, b, max_contacts);
  if (!contacts.isCollision()) return contains(a, b) || contains(b, a);
  const Vec3 mean = mean_contact(contacts);
  return collide(retreated(a, mean), b) && collide(a, retreated(b, mean));
}

}  // namespace

struct Solids::Impl {
  using Bodies = std::map<std::string, Body>;
  struct Meeting {
    const std::string *first, *second;  ///< keys of bodies
    Stance stance;                      ///< of the second to the first
    auto operator<=>(const Meeting&) const = default;
  };

  const ModelTable& models;
  Bodies bodies;
  std::map<Meeting, bool> verdicts;

  Bodies::value_type& body(const Object& object) {
    std::string key = detail::sized_key(object, models);
    if (const auto known = bodies.find(key); known != bodies.end()) return *known;
    Mesh mesh = decimated(detail::sized_mesh(object, models), max_triangles);
    return *bodies.try_emplace(std::move(key), std::move(mesh)).first;
  }

  // Things in rows and around tables meet in the same way again and again.
  bool meet(const Object& a, const Object& b) {
    auto &first = body(a), &second = body(b);
    // Sums of contacts are not the same to the last digit when the two change places.
    if (second.first < first.first) return meet(b, a);
    Stance how = stance(b, a);
    if (&first == &second) how = std::min(how, stance(a, b));
    const Meeting meeting{&first.first, &second.first, how};
    if (const auto known = verdicts.find(meeting); known != verdicts.end()) return known->second;
    if (verdicts.size() >= most_meetings) verdicts.clear();
    const bool verdict = share_space({first.second, Pose3::Identity()}, {second.second, pose_of(how)});
    return verdicts[meeting] = verdict;
  }
};

Solids::Solids(const ModelTable& models) : impl_(std::make_unique<Impl>(Impl{models, {}, {}})) {}
Solids::~Solids() = default;

bool Solids::overlap(const Object& a, const Object& b) {
  return both_solid(a, b) && intersect(a, b);
}

bool Solids::intersect(const Object& a, const Object& b) {
  if (!boxes_overlap(a, b)) return false;
  return impl_->meet(a, b);
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

Footprint core_of_rug(const Footprint& rug) {
  constexpr double core = 0.7;  // of its sides
  return Footprint(rug.center(), 2.0 * core * rug.half(), rug.yaw(), rug.round());
}

bool may_lie_over(const Footprint& rug, const Footprint& larger) {
  constexpr double most_area = 0.7;
  if (rug.area() > most_area * larger.area()) return false;
  const auto corners = core_of_rug(rug).outline();
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec2& corner) { return contains(larger, corner); });
}

bool boxes_clash(const Object& object, const Footprint& footprint, double bottom, const Object& other,
                 const Footprint& footprint_of_other) {
  constexpr double touch = 1e-4;
  if (!footprint.bounds().overlaps(footprint_of_other.bounds(), -touch)) return false;
  if (!both_solid(object, other)) {
    if (!object.traits.flat || !other.traits.flat) return false;
    return overlaps(footprint, footprint_of_other, touch) &&
           !may_lie_over(footprint, footprint_of_other) &&
           !may_lie_over(footprint_of_other, footprint);
  }
  if (bottom >= top(other) - touch || roomgen::bottom(other) >= bottom + object.size.z() - touch)
    return false;
  return overlaps(footprint, footprint_of_other, touch);
}

bool both_solid(const Object& a, const Object& b) {
  return !a.traits.flat && !b.traits.flat;
}

}  // namespace roomgen
