#pragma once

#include <span>
#include <vector>

#include "roomgen/scene/room.h"
#include "thing.h"

namespace roomgen::lab::sceneeval {

/// Is each thing held by what is beside it, as SceneEval's metrics/support.py (version 1.1.1) has it? A
/// thing pulls downward, to the wall behind it or to the ceiling, by its mount; nothing else of the
/// scene file is asked. It is moved 5 mm back, and rays go along the pull from all that is within 10 mm of
/// its foremost point: a contact is what they meet within 10 mm. One contact holds a thing on a wall or
/// under the ceiling. Anything else needs four, not all on one line, and its centroid over their hull.
///
/// Points on faces are drawn with a fixed seed. `mounts` is as long as `things`; the floor is at
/// z = 0, the ceiling at the room's height.
std::vector<bool> supported(std::span<const Thing> things, std::span<const Mount> mounts,
                            const Room& room, const RoomThings& parts);

}  // namespace roomgen::lab::sceneeval
