#pragma once

#include <vector>

#include "roomgen/geometry/vec.h"

namespace roomgen {

/// The corners of the smallest convex polygon around all points, counter-clockwise, none in the
/// middle of a side. Points in one line give its two ends, equal points one.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// Distance from a point to the boundary of a convex hull, positive inside. At most 0 for hulls
/// without area, and -1 for none at all.
double depth_in(const std::vector<Vec2>& hull, const Vec2& point);

}  // namespace roomgen
