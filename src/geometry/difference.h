#pragma once

#include <span>
#include <vector>

#include "triangulate.h"

namespace roomgen {

/// What is left of the polygon without the others, to a micrometre: outer loops counter-clockwise,
/// holes clockwise. The polygon itself, untouched, where nothing overlaps it.
std::vector<Loop> difference(const Polygon& polygon, std::span<const Polygon> others);

}  // namespace roomgen
