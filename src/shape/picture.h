#pragma once

#include <cstdint>

#include "roomgen/geometry/model.h"

namespace roomgen::shape {

/// What hangs on walls and shines from screens, painted without a word of text.
enum class Theme { landscape, abstract, still_life, botanical, map, screen, mirror, clock, plain };

/// An opaque image of this width to height (0.2 to 5), its longer side 256 pixels. A seed gives its
/// own picture; equal arguments give equal pixels.
Image paint_picture(Theme theme, std::uint64_t seed, double aspect);

}  // namespace roomgen::shape
