#pragma once

#include <vector>

#include "camera.h"
#include "roomgen/geometry/model.h"

namespace roomgen {

/// From where a thing alone is looked at.
struct ModelView {
  const char* name;
  double yaw;        ///< of the direction to the viewer from above; 0 is the thing's front
  double elevation;  ///< radians above the horizon
};

/// "front", "side" (its left), "back" and "above" (three-quarter).
const std::vector<ModelView>& model_views();

/// A square picture of what is in the box; all views of one box have one scale.
Camera model_camera(const Bounds3& box, const ModelView& view, int pixels);

}  // namespace roomgen
