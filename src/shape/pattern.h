#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

#include "roomgen/geometry/model.h"

namespace roomgen::shape {

/// What the surface of a material shows beside its colour. All tile seamlessly.
enum class Pattern {
  none,
  grain,    ///< wood, its fibres along u
  weave,    ///< cloth
  marble,   ///< veins
  leather,  ///< small pebbles
  brushed,  ///< metal, scratches along u
  wicker,   ///< a basket of broad strands
  stripes,
  checks,
  speckle,  ///< terrazzo
  rug,      ///< an ornament in a grid of diamonds
  tiles,
};

/// The pattern of one of pattern_names(); none if there is no such one.
Pattern pattern_named(std::string_view name);

/// Metres that one image covers in both directions.
double pattern_extent(Pattern pattern);

/// An opaque image of 256 x 256 in the first colour (sRGB, 0 to 255), the second where the pattern
/// has two: veins, stripes, grout, ornament. Equal arguments give equal pixels.
Image paint_pattern(Pattern pattern, const Eigen::Vector3f& first, const Eigen::Vector3f& second,
                    std::uint64_t seed);

}  // namespace roomgen::shape
