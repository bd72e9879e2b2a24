#pragma once

#include "roomgen/scene/object.h"

namespace roomgen {

/// Of a procedural asset whose parameters are a shape program (docs/shapes.md).
inline constexpr const char* program_recipe = "program";

/// Did somebody write the asset as a shape program?
inline bool is_written(const AssetRef& asset) {
  return asset.procedural && asset.procedural->recipe == program_recipe;
}

}  // namespace roomgen
