#include "roomgen/scene/model_table.h"

namespace roomgen {

void ModelTable::add(const std::string& key, std::shared_ptr<const Model> model) {
  models_[key] = std::move(model);
}

std::shared_ptr<const Model> ModelTable::find(std::string_view key) const {
  const auto found = models_.find(key);
  return found == models_.end() ? nullptr : found->second;
}

ModelPlacement model_placement(const Object& object, const Bounds3& model_bounds) {
  ModelPlacement placement;
  placement.yaw = object.yaw;
  placement.position = object.position;
  const Vec3 extent = model_bounds.size();
  for (int axis = 0; axis < 3; ++axis)
    if (extent[axis] > 1e-6) placement.scale[axis] = object.size[axis] / extent[axis];
  return placement;
}

}  // namespace roomgen
