#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oriented_box.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/room.h"

namespace roomgen::lab {

/// A surface in the room with what the measures ask of it: its box, its triangles in room
/// coordinates, rays, distances. A tree is made when first asked for and shared by copies. Not for
/// use by two threads at once.
class Thing {
 public:
  Thing(const OrientedBox& box, Mesh mesh);

  const OrientedBox& box() const;
  const Mesh& mesh() const;
  const Bounds3& bounds() const;
  /// Area-weighted mean of the surface.
  const Vec3& centroid() const;
  /// Distance along the ray to the first triangle it meets, not behind the origin.
  std::optional<double> ray(const Vec3& origin, const Vec3& direction) const;
  /// From the nearest point of a filled box to this surface; 0 when they meet.
  double distance_from(const OrientedBox& box) const;
  Vec3 closest_point(const Vec3& point) const;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

/// The object's mesh where it stands, or its box.
Thing thing_of(const Object& object, const ModelTable& models);

/// The parts of the room as SceneEval sees them: walls with their openings cut out, doors and windows
/// as boxes that fill them.
struct RoomThings {
  std::vector<Thing> walls, doors, windows;  ///< passages are doors
};
RoomThings room_things(const Room& room);

}  // namespace roomgen::lab
