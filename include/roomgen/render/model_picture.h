#pragma once

#include <memory>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/image.h"
#include "roomgen/geometry/model.h"
#include "roomgen/view/camera.h"

namespace roomgen {

/// A model alone on a plain floor, without a room: one picture for each camera. Needs what
/// make_osmesa_renderer() needs.
Result<std::vector<Image>> draw_model(const std::shared_ptr<const Model>& model,
                                      const std::vector<Camera>& cameras);

/// Pictures of one size side by side, `columns` in a row.
Image contact_sheet(const std::vector<Image>& pictures, int columns);

}  // namespace roomgen
