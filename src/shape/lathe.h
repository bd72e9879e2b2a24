#pragma once

#include "chain.h"
#include "surface.h"

namespace roomgen::shape {

/// The body of a profile of (radius, z) turned by `angle`: a closed profile counter-clockwise in
/// the plane of radius and height, or an open one from the lower to the upper end of the axis, both
/// of its ends on it.
Mesh turned(const Chain2& profile, double angle, double tolerance);

}  // namespace roomgen::shape
