#include "roomgen/evaluate/thing.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>

#include "ray_tree.h"
#include "roomgen/geometry/centroid.h"
#include "roomgen/scene/box_model.h"
#include "roomgen/scene/room_shell.h"

namespace roomgen {

namespace {

constexpr std::size_t max_contacts = 100000;  // as trimesh has it

using CollisionTree = fcl::BVHModel<fcl::OBBd>;
using DistanceTree = fcl::BVHModel<fcl::OBBRSSd>;

template <typename Tree>
std::unique_ptr<Tree> make_tree(const Mesh& mesh) {
  auto tree = std::make_unique<Tree>();
  tree->beginModel(static_cast<int>(mesh.triangles.size()),
                   static_cast<int>(mesh.positions.size()));
  for (const auto& t : mesh.triangles)
    tree->addTriangle(mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
                      mesh.positions[t[2]].cast<double>());
  tree->endModel();
  return tree;
}

Mesh placed(Mesh mesh, const OrientedBox& frame) {
  for (auto& position : mesh.positions)
    position = frame.to_world(position.cast<double>()).cast<float>();
  mesh.normals.clear();
  mesh.uvs.clear();
  return mesh;
}

Mesh mesh_of(const OrientedBox& box) { return placed(make_box(-box.half, box.half), box); }

}  // namespace

struct Thing::Impl {
  OrientedBox box;
  Mesh mesh;
  Bounds3 bounds;
  Vec3 centroid = Vec3::Zero();
  std::unique_ptr<CollisionTree> collision;
  std::unique_ptr<DistanceTree> distance;
  std::unique_ptr<RayTree> rays;

  CollisionTree* collision_tree() {
    if (!collision) collision = make_tree<CollisionTree>(mesh);
    return collision.get();
  }
  DistanceTree* distance_tree() {
    if (!distance) distance = make_tree<DistanceTree>(mesh);
    return distance.get();
  }
  const RayTree& ray_tree() {
    if (!rays) rays = std::make_unique<RayTree>(mesh);
    return *rays;
  }
};

Thing::Thing(const OrientedBox& box, Mesh mesh) : impl_(std::make_shared<Impl>()) {
  impl_->box = box;
  impl_->mesh = std::move(mesh);
  impl_->bounds = roomgen::bounds(impl_->mesh);
  impl_->centroid = surface_centroid(impl_->mesh);
}

const OrientedBox& Thing::box() const { return impl_->box; }
const Mesh& Thing::mesh() const { return impl_->mesh; }
const Bounds3& Thing::bounds() const { return impl_->bounds; }
const Vec3& Thing::centroid() const { return impl_->centroid; }

std::optional<double> Thing::ray(const Vec3& origin, const Vec3& direction) const {
  return impl_->ray_tree().first_hit(origin, direction);
}

Vec3 Thing::closest_point(const Vec3& point) const { return impl_->ray_tree().closest(point); }

double Thing::distance_from(const OrientedBox& box) const {
  for (const auto& position : impl_->mesh.positions)
    if (box.contains(position.cast<double>())) return 0.0;
  const auto other = make_tree<DistanceTree>(mesh_of(box));
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(impl_->distance_tree(), fcl::Transform3d::Identity(), other.get(),
                fcl::Transform3d::Identity(), request, result);
  return std::max(result.min_distance, 0.0);
}

bool Thing::collides(const Thing& other, double retreat) const {
  const auto& a = impl_->bounds;
  const auto& b = other.impl_->bounds;
  if ((a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any())
    return false;
  auto* tree = impl_->collision_tree();
  auto* other_tree = other.impl_->collision_tree();
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  fcl::CollisionResultd result;
  fcl::collide(tree, pose, other_tree, pose, fcl::CollisionRequestd(max_contacts, true), result);
  if (!result.isCollision()) return false;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < result.numContacts(); ++i) mean += result.getContact(i).pos;
  mean /= static_cast<double>(result.numContacts());
  const Vec3 away = other.centroid() - mean;
  if (away.norm() < 1e-9) return true;
  fcl::Transform3d moved = fcl::Transform3d::Identity();
  moved.translation() = retreat * away.normalized();
  fcl::CollisionResultd again;
  fcl::collide(tree, pose, other_tree, moved, fcl::CollisionRequestd(1, false), again);
  return again.isCollision();
}

Thing thing_of(const Object& object, const ModelTable& models) {
  const auto model = model_or_box(object, models);
  const Bounds3 model_bounds = bounds(*model);
  const ModelPlacement placement = model_placement(object, model_bounds);
  Mesh mesh;
  append(mesh, merged_mesh(*model), placement.scale);
  const OrientedBox frame{placement.position, Vec3::Zero(), placement.yaw};
  return Thing(box_of(object), placed(std::move(mesh), frame));
}

namespace {

// A box as wide and high as that stretch of the wall and as deep as the wall; its front looks in.
OrientedBox wall_box(const Room& room, std::size_t wall, double from, double to, double low,
                     double high) {
  const Segment edge = room.polygon.edge(wall);
  const Vec2 inward = room.polygon.inward(wall);
  const Vec2 middle = edge.a + 0.5 * (from + to) * edge.direction() - 0.5 * wall_thickness * inward;
  return {{middle.x(), middle.y(), 0.5 * (low + high)},
          {0.5 * (to - from), 0.5 * wall_thickness, 0.5 * (high - low)},
          yaw_facing(inward)};
}

}  // namespace

RoomThings room_things(const Room& room) {
  RoomThings things;
  ShellOptions plain;
  plain.skirting = plain.window_frames = plain.door_frames = plain.door_leaves = false;
  const auto parts = room_shell(room, plain);
  for (std::size_t wall = 0; wall < room.polygon.size(); ++wall) {
    const auto box = wall_box(room, wall, 0.0, room.polygon.edge(wall).length(), 0.0, room.height);
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const ShellPart& p) {
      return p.name == "wall-" + std::to_string(wall);
    });
    things.walls.emplace_back(box, part == parts.end() ? mesh_of(box) : merged_mesh(part->model));
  }
  for (const auto& opening : room.openings) {
    const auto box =
        wall_box(room, opening.wall, opening.from, opening.to, opening.sill, opening.head);
    auto& kind = opening.is_entrance() ? things.doors : things.windows;
    kind.emplace_back(box, mesh_of(box));
  }
  return things;
}

}  // namespace roomgen
