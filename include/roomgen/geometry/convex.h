#pragma once

#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// What is left of the tiles without `hole`. Tiles that it touches come back in convex pieces;
/// slivers of less than 1e-8 m2 are dropped.
std::vector<Polygon> subtract(const std::vector<Polygon>& tiles, const Polygon& hole);

}  // namespace roomgen
