#pragma once

#include "roomgen/scene/room.h"
#include "thing.h"

/// SceneEval's measures of what stands how in the room, version 1.1.1.
namespace roomgen::lab::sceneeval {

/// Whether a point of the plan is in the room; flush to a wall it is.
bool is_over_floor(const Vec2& place, const Room& room);

/// The share of the surface that lies above the floor, from max(1000, 5000 a cubic metre of the box)
/// points drawn with a fixed seed. Below 0.99 the thing is out of bounds.
double share_in_bounds(const Thing& thing, const Room& room);
inline constexpr double least_share_in_bounds = 0.99;

}  // namespace roomgen::lab::sceneeval
