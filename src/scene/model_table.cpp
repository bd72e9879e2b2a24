#include "roomgen/scene/scene.h"

#include <algorithm>

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

bool keeps_to_ellipse(const Model& model, const Vec3& size) {
  constexpr double tolerance = 0.01;
  const Bounds3 box = bounds(model);
  const Vec2 half = 0.5 * size.head<2>();
  const auto is_within = [&](const Eigen::Vector3f& position) {
    const Vec2 offset = (position.cast<double>() - box.center()).head<2>();
    const Vec2 unit = 2.0 * offset.cwiseQuotient(box.size().head<2>().cwiseMax(1e-9));
    // Along the ray from the middle, which for circles is the distance.
    const double out = unit.norm() - 1.0;
    return out <= 0.0 || out / (1.0 + out) * unit.cwiseProduct(half).norm() <= tolerance;
  };
  return std::all_of(model.parts.begin(), model.parts.end(), [&](const ModelPart& part) {
    return std::all_of(part.mesh.positions.begin(), part.mesh.positions.end(), is_within);
  });
}

}  // namespace roomgen
