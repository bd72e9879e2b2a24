#pragma once

#include <span>
#include <vector>

#include "oriented_box.h"
#include "roomgen/scene/room.h"

namespace roomgen::lab::sceneeval {

/// What stands before each door and window, by index, in the order of the openings (SceneEval's
/// metrics/opening_clearance.py, version 1.1.1): whose box reaches into the opening's rectangle drawn
/// into the room, by its width before a door and by 0.5 m before a window. Rugs count.
std::vector<std::vector<std::size_t>> in_the_way(std::span<const OrientedBox> boxes,
                                                 const Room& room);

}  // namespace roomgen::lab::sceneeval
