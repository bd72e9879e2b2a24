#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/geometry/footprint.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/mount.h"
#include "roomgen/scene/asset_ref.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// A thing in the room.
struct Object {
  std::string id;  ///< "bed-0": lower case, category and a number
  std::string category;
  std::string description;
  AssetRef asset;
  Traits traits;
  Vec3 size = Vec3::Ones();       ///< width, depth, height of its box, metres
  Vec3 position = Vec3::Zero();   ///< bottom centre of the placed box
  double yaw = 0.0;               ///< radians, counter-clockwise; at 0 the front looks to -Y
  Mount mount = Mount::floor;
  std::string on;                 ///< id of the object under it, for Mount::surface
  std::vector<Relation> relations;
  bool locked = false;            ///< neither repair nor improvement may move it
  std::string room;               ///< id of its room in a dwelling, else empty
};

inline Footprint footprint(const Object& object) {
  return Footprint(object.position.head<2>(), object.size.head<2>(), object.yaw,
                   object.traits.round);
}
inline double bottom(const Object& object) { return object.position.z(); }
inline double top(const Object& object) { return object.position.z() + object.size.z(); }

/// The pose as a file holds it: coordinates to 0.1 mm, yaw to 0.001 degrees in (-180, 180]. What is
/// checked should be what is written.
Object with_rounded_pose(Object object);

/// Does the object stand on the thing of that id, or does a relation of it name it?
bool depends_on(const Object& object, std::string_view id);

}  // namespace roomgen
