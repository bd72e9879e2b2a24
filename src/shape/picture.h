#pragma once

#include <cstdint>

#include "roomgen/geometry/model.h"

namespace roomgen::shape {

/// What is painted and not drawn (drawing.h).
enum class Theme { screen, mirror, clock, plain };

/// An opaque image of this width to height (0.2 to 5), its longer side 256 pixels. A seed gives its
/// own picture; equal arguments give equal pixels.
Image paint_picture(Theme theme, std::uint64_t seed, double aspect);

}  // namespace roomgen::shape
