#pragma once

#include "brief/brief.h"
#include "brief/room_kinds.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// The plan for a request whose sizes are sound and whose prompt says what `brief` holds. Each plan has a dry run:
/// its things are placed as boxes, and where some find no place, another room or another selection is tried; at last
/// what was not asked for is left out. Fails with invalid_input where nothing that makes the room what it is called
/// finds a place (needed_makers()); the message says what, and the least size that would do.
Result<Plan> make_plan(const PlanRequest& request, const brief::Brief& brief,
                       const brief::RoomKinds& kinds, const KindTable& table,
                       const Arrangements& arrangements);

}  // namespace roomgen::plan
