#pragma once

#include "roomgen/geometry/model.h"

namespace roomgen {

/// How a surface lets things behind it through; glTF 2.0's alphaMode.
enum class AlphaMode {
  opaque,
  mask,   ///< all or nothing, texel by texel: foliage, fences
  blend,  ///< glass, curtains
};

/// From the material's alpha and from the texture, of which it looks at every texel.
AlphaMode alpha_mode(const Material& material);

}  // namespace roomgen
