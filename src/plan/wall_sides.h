#pragma once

#include <cstddef>
#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen::plan {

/// The walls of a polygon that look to a direction (at most 45 degrees off), the longest first.
std::vector<std::size_t> walls_towards(const Polygon& polygon, const Vec2& direction);

/// The same for a side of a rectangle: 0 the front wall (lower on the plan), then counter-clockwise
/// 1 the right, 2 the back, 3 the left one.
std::vector<std::size_t> walls_on_side(const Polygon& polygon, int side);

/// The one wall that stands for a side: where several look there, the longest; where none does, the
/// one that comes nearest.
std::size_t wall_on_side(const Polygon& polygon, std::size_t side);

}  // namespace roomgen::plan
