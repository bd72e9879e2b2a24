#include "thing.h"

#include <algorithm>

#include "geometry/centroid.h"
#include "geometry/mesh_tree.h"
#include "scene/box_model.h"
#include "scene/room_shell.h"

namespace roomgen::lab {

namespace {

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

  const MeshTree& tree() {
    if (!tree_) tree_.emplace(mesh);
    return *tree_;
  }

 private:
  std::optional<MeshTree> tree_;
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
  return impl_->tree().first_hit({origin, direction});
}

Vec3 Thing::closest_point(const Vec3& point) const {
  return impl_->tree().closest_point(point).value_or(point);
}

double Thing::distance_from(const OrientedBox& box) const {
  for (const auto& position : impl_->mesh.positions)
    if (box.contains(position.cast<double>())) return 0.0;
  NearestPoints nearest{std::numeric_limits<double>::max()};
  impl_->tree().nearest(MeshTree(mesh_of(box)), nearest);
  return nearest.distance;
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

}  // namespace roomgen::lab
