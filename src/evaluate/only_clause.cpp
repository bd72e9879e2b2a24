#include <algorithm>

#include "clauses.h"
#include "scene/attribute_names.h"

namespace roomgen {

namespace {

bool is_one_of(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// On a target itself, or on what is on it.
bool stands_on_any(const std::vector<std::string>& targets, const Object& object, const Scene& scene) {
  constexpr int highest = 10;
  const Object* carried = &object;
  for (int n = 0; carried && n < highest; ++n) {
    if (is_one_of(targets, carried->on)) return true;
    carried = carried->on.empty() ? nullptr : find_object(scene, carried->on);
  }
  return false;
}

}  // namespace

std::string other_fault(const Requirement& requirement, const Scene& scene,
                        const std::function<bool(const Object&)>& is_of_kind) {
  for (const auto& object : scene.objects) {
    if (is_one_of(requirement.subjects, object.id) || is_one_of(requirement.targets, object.id)) continue;
    if (!requirement.category.empty() && !is_of_kind(object)) continue;
    if (!requirement.targets.empty() && !stands_on_any(requirement.targets, object, scene)) continue;
    if (requirement.attribute.starts_with(mount_attribute) &&
        requirement.attribute.substr(mount_attribute.size()) != name(object.mount))
      continue;
    return "there is " + object.id + " as well";
  }
  return "";
}

}  // namespace roomgen
