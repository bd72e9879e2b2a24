#include "roomgen/scene/object.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"

namespace roomgen {

Object with_rounded_pose(Object object) {
  for (int axis = 0; axis < 3; ++axis) object.position[axis] = rounded(object.position[axis]);
  object.yaw = radians(rounded(degrees(wrap_angle(object.yaw)), 3));
  return object;
}

bool depends_on(const Object& object, std::string_view id) {
  return object.on == id ||
         std::any_of(object.relations.begin(), object.relations.end(),
                     [&](const Relation& relation) { return relation.target == id; });
}

}  // namespace roomgen
