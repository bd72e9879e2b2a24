#pragma once

#include <span>
#include <vector>

#include "oriented_box.h"
#include "roomgen/scene/room.h"
#include "thing.h"

namespace roomgen::lab::sceneeval {

/// SceneEval's measures of what stands how in the room, version 1.1.1.

/// Whether a point of the plan is in the room; flush to a wall it is.
bool is_over_floor(const Vec2& place, const Room& room);

/// The share of the surface that lies above the floor, from max(1000, 5000 a cubic metre of the
/// box) points drawn with a fixed seed. Below 0.99 the thing is out of bounds.
double share_in_bounds(const Thing& thing, const Room& room);
inline constexpr double least_share_in_bounds = 0.99;

/// The share of the free floor that hangs together, as SceneEval's metrics/navigability.py (version
/// 1.1.1) has it: a map of 256 x 256 cells, the floor without what is nearer than half a robot's
/// width of 0.2 m to its edge, without the boxes whose middle is at most 2 m high, made larger by
/// as much. The largest part, corners touching, over all; 0 where nothing is free. Doors do not
/// matter.
double navigability(std::span<const OrientedBox> boxes, const Room& room);

/// What stands before each door and window, by index, in the order of the openings (SceneEval's
/// metrics/opening_clearance.py, version 1.1.1): whose box reaches into the opening's rectangle
/// drawn into the room, by its width before a door and by 0.5 m before a window. Rugs count.
std::vector<std::vector<std::size_t>> in_the_way(std::span<const OrientedBox> boxes,
                                                 const Room& room);

/// Is each thing held by what is beside it, as SceneEval's metrics/support.py (version 1.1.1) has
/// it? A thing pulls downward, to the wall behind it or to the ceiling, by its mount; nothing else
/// of the scene file is asked. It is moved 5 mm back, and rays go along the pull from all that is
/// within 10 mm of its foremost point: a contact is what they meet within 10 mm. One contact holds
/// a thing on a wall or under the ceiling. Anything else needs four, not all on one line, and its
/// centroid over their hull.
///
/// Points on faces are drawn with a fixed seed. `mounts` is as long as `things`; the floor is at
/// z = 0, the ceiling at the room's height.
std::vector<bool> supported(std::span<const Thing> things, std::span<const Mount> mounts,
                            const Room& room, const RoomThings& parts);

}  // namespace roomgen::lab::sceneeval
