#pragma once

#include <vector>

#include "placing.h"

namespace roomgen {

/// All points of the floor 5 cm apart where a thing of the cluster's root fits by its box, square to the walls or
/// turned as the aim says, the nearest to `middle` first: what is left to look at when no pose with a meaning
/// will do.
std::vector<Pose> floor_points(const Layout& layout, const Object& root, const Aim& aim, const Vec2& middle);

}  // namespace roomgen
