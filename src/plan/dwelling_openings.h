#pragma once

#include <vector>

#include "base/random.h"
#include "brief/dwelling_kinds.h"
#include "brief/room_kinds.h"
#include "dwelling_layout.h"
#include "roomgen/scene/room.h"

namespace roomgen::plan {

/// Gives rooms their doors, passages and windows: one way from each room to its parent, passages
/// between rooms that are open to each other, an entrance into the hub, windows in outer walls
/// only. `rooms` stand as `laid` says, in the same order.
void open_up(std::vector<Room>& rooms, const std::vector<LaidRoom>& laid,
             const brief::DwellingKinds& dwellings, const brief::RoomKinds& kinds, Random random);

}  // namespace roomgen::plan
