#include "roomgen/scene/object.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rounded_pose.h"

namespace roomgen {

Vec3 rounded_position(const Vec3& position) {
  return {rounded(position.x()), rounded(position.y()), rounded(position.z())};
}

double rounded_yaw(double yaw) { return radians(rounded(degrees(wrap_angle(yaw)), 3)); }

Object with_rounded_pose(Object object) {
  object.position = rounded_position(object.position);
  object.yaw = rounded_yaw(object.yaw);
  return object;
}

bool depends_on(const Object& object, std::string_view id) {
  return object.on == id ||
         std::any_of(object.relations.begin(), object.relations.end(),
                     [&](const Relation& relation) { return relation.target == id; });
}

}  // namespace roomgen
