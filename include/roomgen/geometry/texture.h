#pragma once

#include <Eigen/Core>

#include "roomgen/geometry/image.h"

namespace roomgen {

/// Surfaces painted by formula instead of taken from photographs. All tile seamlessly.
enum class TexturePattern {
  planks,   ///< wooden boards, 0.15 m wide, staggered
  decking,  ///< outdoor boards with open joints
  tiles,    ///< ceramic squares of 0.30 m with grout
  stone,    ///< polished slabs of 0.60 m with veins
  carpet,
  concrete,
};

/// Length of floor, in metres, that one image of this pattern covers in both directions.
double texture_extent(TexturePattern pattern);

/// An opaque image around `tone` (sRGB, 0 to 255). Equal arguments give equal pixels.
Image paint_texture(TexturePattern pattern, const Eigen::Vector3f& tone);

}  // namespace roomgen
