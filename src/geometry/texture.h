#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "roomgen/geometry/model.h"

namespace roomgen {

/// Surfaces painted by formula instead of taken from photographs. All tile seamlessly.
enum class TexturePattern {
  planks,        ///< wooden boards, 0.15 m wide, staggered
  decking,       ///< outdoor boards with open joints
  herringbone,   ///< parquet of 0.075 x 0.30 m
  panels,        ///< upright wooden boards of 0.12 m with a groove between them
  tiles,         ///< ceramic squares of 0.30 m with grout
  subway,        ///< glazed tiles of 0.20 x 0.10 m in running bond
  checkerboard,  ///< squares of 0.30 m in two tones
  stone,         ///< polished slabs of 0.60 m with veins
  bricks,        ///< 0.25 x 0.0833 m with their joints, in running bond
  carpet,
  concrete,
  stripes,       ///< wallpaper: upright stripes of 0.075 m in two tones
  dots,          ///< wallpaper: staggered dots, 0.06 m wide
  sprigs,        ///< wallpaper: staggered sprigs of leaves
};

/// Length of floor or wall, in metres, that one image of this pattern covers in both directions.
double texture_extent(TexturePattern pattern);

/// "planks", as data files name them; none for other words.
std::optional<TexturePattern> parse_texture_pattern(std::string_view name);
const std::vector<TexturePattern>& all_texture_patterns();
std::string_view name(TexturePattern pattern);

/// Does the pattern have two tones of one rank? In the others the second one is what fills the joints.
bool has_two_tones(TexturePattern pattern);

/// An opaque image around `tone` (sRGB, 0 to 255); `second` is the other tone or that of the joints, as
/// far as the pattern has any. Rows run downwards, so that walls show bricks lying and panels upright.
/// Equal arguments give equal pixels.
Image paint_texture(TexturePattern pattern, const Eigen::Vector3f& tone,
                    const Eigen::Vector3f& second);

}  // namespace roomgen
