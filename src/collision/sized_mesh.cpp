#include "sized_mesh.h"

#include <cmath>

#include "scene/box_model.h"

namespace roomgen::detail {

Mesh sized_mesh(const Object& object, const ModelTable& models) {
  const auto model = model_or_box(object, models);
  Mesh mesh = triangle_count(*model) > 0 ? merged_mesh(*model) : merged_mesh(box_model(object));
  Mesh sized;
  append(sized, mesh, model_placement(object, bounds(mesh)).scale);
  return sized;
}

std::string sized_key(const Object& object, const ModelTable& models) {
  std::string key = model_key(object, models);
  for (int axis = 0; axis < 3; ++axis)
    key += "|" + std::to_string(std::lround(object.size[axis] * 1e4));
  return key;
}

}  // namespace roomgen::detail
