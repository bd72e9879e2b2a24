#pragma once

#include "roomgen/base/json.h"
#include "roomgen/view/view.h"

namespace roomgen {

/// A camera as files have it (docs/layers.md).
Json camera_json(const Camera& camera);

}  // namespace roomgen
