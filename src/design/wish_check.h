#pragma once

#include "brief/brief.h"
#include "roomgen/scene/plan.h"

namespace roomgen::design {

/// Whether the knowledge that is compiled in can be read.
Status check_knowledge();
/// Whether a request can be planned: its prompt, its sizes, its room.
Status check_request(const PlanRequest& request);
/// Furnishing a room that nobody asked for would be worse than saying so.
Status check_understood(const PlanRequest& request, const brief::Brief& brief);

}  // namespace roomgen::design
