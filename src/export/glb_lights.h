#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "roomgen/base/json.h"
#include "scene/lights.h"

namespace roomgen::detail {

/// The lights of a glTF file (extension KHR_lights_punctual): equal ones are written once.
class GlbLights {
 public:
  /// Nodes in the axes of glTF.
  Json lamp_node(const LampLight& lamp);
  Json sun_node(const Sunlight& sun);

  /// Fills "extensions" and "extensionsUsed" if there are any lights.
  void finish(Json& gltf);

 private:
  Json node_of(const std::string& name, Json light);

  std::map<std::string, int> light_by_text_;
  Json lights_ = Json::array();
};

}  // namespace roomgen::detail
