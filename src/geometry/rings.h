#pragma once

#include <cstdint>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"

/// The steps of triangulation. Rings are loops by the indices of their points.
namespace roomgen::detail {

using Index = std::uint32_t;
using Ring = std::vector<Index>;

/// Positive for a turn to the left at b.
inline double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - b); }

/// Do the boxes of two segments share a point? Cheaper than intersects().
bool boxes_touch(const Segment& s, const Segment& t);

/// One ring of an outer one and of the holes in it, joined by pairs of edges there and back.
Ring bridged(const std::vector<Vec2>& points, Ring ring, std::vector<Ring> holes);

/// Triangles of a ring that may touch itself. The roundest ear is always taken first, so that
/// points in line do not end up as slivers.
void clip_ears(const std::vector<Vec2>& points, Ring ring, std::vector<Triangle>& triangles);

/// Turns diagonals until each is the better one of its quadrangle (Lawson 1977).
void flip_diagonals(const std::vector<Vec2>& points, std::vector<Triangle>& triangles);

}  // namespace roomgen::detail
