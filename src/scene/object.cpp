#include "roomgen/scene/object.h"

#include <algorithm>
#include <array>

#include "roomgen/base/json.h"

namespace roomgen {

namespace {
constexpr std::array<std::string_view, 4> mount_names = {"floor", "wall", "ceiling", "surface"};
}

Object with_rounded_pose(Object object) {
  for (int axis = 0; axis < 3; ++axis) object.position[axis] = rounded(object.position[axis]);
  object.yaw = radians(rounded(degrees(wrap_angle(object.yaw)), 3));
  return object;
}

std::string_view name(Mount mount) {
  return mount_names[static_cast<std::size_t>(mount)];
}

std::optional<Mount> parse_mount(std::string_view text) {
  for (std::size_t i = 0; i < mount_names.size(); ++i)
    if (mount_names[i] == text) return static_cast<Mount>(i);
  return std::nullopt;
}

bool depends_on(const Object& object, std::string_view id) {
  return object.on == id ||
         std::any_of(object.relations.begin(), object.relations.end(),
                     [&](const Relation& relation) { return relation.target == id; });
}

}  // namespace roomgen
