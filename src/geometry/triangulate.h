#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// A closed line by its corners, not repeating the first one.
using Loop = std::vector<Vec2>;

/// No two edges of the loop cross or touch, neighbours aside.
bool is_simple(const Loop& loop);

/// Triangles between loops, counter-clockwise, in indices of the loops' points one after the other:
/// ear clipping, then the better diagonals. Outer loops run counter-clockwise, holes clockwise; loops
/// may be nested in one another but not cross. Every point is used, those in the middle of a straight
/// side too.
std::vector<Triangle> triangulate(const std::vector<Loop>& loops);
std::vector<Triangle> triangulate(const Polygon& polygon);

/// What is left of the polygon without the others, to a micrometre: outer loops counter-clockwise,
/// holes clockwise. The polygon itself, untouched, where nothing overlaps it.
std::vector<Loop> difference(const Polygon& polygon, std::span<const Polygon> others);

/// What lies within half the width of any of the lines, to a micrometre, round at ends and corners to
/// `tolerance`: loops as those of difference().
std::vector<Loop> around_lines(std::span<const Loop> lines, double width, double tolerance);

}  // namespace roomgen
