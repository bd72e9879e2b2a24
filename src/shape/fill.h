#pragma once

#include <vector>

#include "roomgen/geometry/mesh.h"

namespace roomgen::shape {

using Loop = std::vector<Vec2>;

/// No two edges of the closed loop cross or touch, neighbours aside.
bool is_simple(const Loop& loop);

/// Triangles between loops, counter-clockwise, in indices of the loops' points one after the other.
/// Outer loops run counter-clockwise, holes clockwise; loops may be nested in one another but not
/// cross. Every point is used, those in the middle of a straight side too.
std::vector<Triangle> fill(const std::vector<Loop>& loops);

}  // namespace roomgen::shape
