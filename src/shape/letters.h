#pragma once

#include <string_view>
#include <vector>

#include "roomgen/shape/primitives.h"

namespace roomgen::shape {

enum class Align { left, center, right };

struct Lettering {
  std::vector<Curve<Vec2>> lines;
  double height = 0.0;  ///< of a capital
};

/// Words as the lines that a pen draws (data/letters.json), capitals as high as `height` unless
/// they must be smaller to keep within `fit`, their width and height (0: any). Half of the height
/// lies above y = 0; `align` puts x = 0 at the left, the middle or the right. Small letters are
/// written as capitals, other marks than the font's left out as blanks are.
Lettering lettering(std::string_view words, Align align, double height,
                    const Vec2& fit = Vec2::Zero());

inline constexpr std::size_t most_letters = 240;

}  // namespace roomgen::shape
