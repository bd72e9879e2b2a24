#pragma once

#include "arrangement.h"
#include "brief/room_kinds.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::design {

/// The plan for a request whose prompt and sizes are sound. Each plan is rehearsed: its things are
/// placed in a sketch of the room, and where some find no place, another room or another selection
/// is tried; at last what was not asked for is left out.
Plan make_plan(const PlanRequest& request, const RoomKinds& kinds, const KindTable& table,
               const Arrangements& arrangements);

}  // namespace roomgen::design
