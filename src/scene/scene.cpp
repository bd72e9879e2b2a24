#include "roomgen/scene/scene.h"

#include <set>

namespace roomgen {

const Object* find_object(const Scene& scene, std::string_view id) {
  for (const auto& object : scene.objects)
    if (object.id == id) return &object;
  return nullptr;
}

Object* find_object(Scene& scene, std::string_view id) {
  return const_cast<Object*>(find_object(static_cast<const Scene&>(scene), id));
}

Status check(const Scene& scene) {
  if (auto status = check(scene.room); !status) return status;
  std::set<std::string, std::less<>> ids;
  const auto error = [](const Object& object, const std::string& what) {
    return Error{Error::Kind::invalid_input, "object \"" + object.id + "\": " + what};
  };
  for (const auto& object : scene.objects) {
    if (object.id.empty()) return error(object, "has no id");
    if (!ids.insert(object.id).second) return error(object, "there are two of this id");
    if (!(object.size.minCoeff() > 0)) return error(object, "its size must be positive");
  }
  for (const auto& object : scene.objects) {
    if (object.mount == Mount::surface && !ids.count(object.on))
      return error(object, "stands on \"" + object.on + "\", which is not in the scene");
  }
  return {};
}

}  // namespace roomgen
