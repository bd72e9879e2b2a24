#pragma once

#include <span>

#include "oriented_box.h"
#include "roomgen/scene/room.h"

namespace roomgen::lab::sceneeval {

/// The share of the free floor that hangs together, as SceneEval's metrics/navigability.py (version
/// 1.1.1) has it: a map of 256 x 256 cells, the floor without what is nearer than half a robot's width
/// of 0.2 m to its edge, without the boxes whose middle is at most 2 m high, made larger by as much.
/// The largest part, corners touching, over all; 0 where nothing is free. Doors do not matter.
double navigability(std::span<const OrientedBox> boxes, const Room& room);

}  // namespace roomgen::lab::sceneeval
