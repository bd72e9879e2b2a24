#pragma once

#include <cstdint>
#include <string>

#include "base/json_reader.h"
#include "canvas.h"
#include "numbers.h"

/// Pictures drawn in flat colours (docs/shapes.md, Drawings). They are painted as they are read, so
/// that what can be read can be painted.
namespace roomgen::shape {

/// One colour over an area.
struct Paint {
  Outlines outlines;  ///< in the drawing's frame, whatever they wind around
  Tint color;
  double opacity = 1.0;
};

struct Drawing {
  Tint ground;
  std::vector<Paint> paints;  ///< in their order
};

/// Reports what is wrong. `seed` decides what is left to chance: what is scattered, which ground of
/// several, which way round a motif stands.
Drawing read_drawing(const JsonReader& json, const detail::Numbers& numbers, std::uint64_t seed);

/// The same drawing with all formulas and "$names" put in, as a text that paint_drawing() takes.
std::string concrete_drawing(const JsonReader& json, const detail::Numbers& numbers);

/// Of this width to height (0.2 to 5), its longer side 512 pixels; white where the text is no
/// drawing.
Image paint_drawing(const std::string& text, std::uint64_t seed, double aspect);

}  // namespace roomgen::shape
