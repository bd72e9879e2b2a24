#pragma once

#include <span>
#include <utility>
#include <vector>

#include "roomgen/evaluate/thing.h"
#include "roomgen/scene/room.h"

/// SceneEval's measures of what stands how in the room, version 1.1.1.
namespace roomgen::sceneeval {

/// Pairs whose meshes cross and still do after the second is moved 5 mm away, by index. One thing
/// inside another without touching goes unseen.
std::vector<std::pair<std::size_t, std::size_t>> collisions(std::span<const Thing> things);

/// The share of the surface that lies above the floor, from max(1000, 5000 a cubic metre of the box)
/// points drawn with a fixed seed. Below 0.99 the thing is out of bounds.
double share_in_bounds(const Thing& thing, const Room& room);
inline constexpr double least_share_in_bounds = 0.99;

}  // namespace roomgen::sceneeval
