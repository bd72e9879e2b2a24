#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// The largest axis-aligned rectangles of floor that no footprint touches, on a grid of 0.1 m: the
/// largest first, then the largest of what remains without it, and so on. At most `most` of them,
/// none with a side shorter than `least_side` metres.
std::vector<Bounds2> free_rectangles(const Polygon& floor, std::span<const Footprint> taken,
                                     double least_side, std::size_t most);

}  // namespace roomgen
