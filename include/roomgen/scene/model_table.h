#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "roomgen/geometry/model.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// The meshes of a scene, by asset_key(). Models are shared, not copied; an object without a model
/// counts as its box.
class ModelTable {
 public:
  void add(const std::string& key, std::shared_ptr<const Model> model);
  /// Null if there is none.
  std::shared_ptr<const Model> find(std::string_view key) const;
  bool empty() const { return models_.empty(); }

 private:
  std::map<std::string, std::shared_ptr<const Model>, std::less<>> models_;
};

/// Maps model coordinates to the room: p_room = R(yaw) * (scale * p_model) + position. The scale,
/// axis by axis, makes the model's box exactly `object.size`.
struct ModelPlacement {
  Vec3 scale = Vec3::Ones();
  double yaw = 0.0;
  Vec3 position = Vec3::Zero();
};
ModelPlacement model_placement(const Object& object, const Bounds3& model_bounds);

/// Does the model, at a size in metres, stay within the ellipse inscribed in its box from above, by
/// a centimetre? Only then may an object that is made of it be `round`.
bool keeps_to_ellipse(const Model& model, const Vec3& size);

}  // namespace roomgen
