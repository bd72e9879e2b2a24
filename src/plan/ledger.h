#pragma once

#include <vector>

#include "brief/brief.h"
#include "inventory.h"
#include "roomgen/scene/plan.h"

namespace roomgen::design {

/// Every clause of the prompt that can be checked: how many of each thing, how they look, how they
/// stand to others and to the room, what is not there. `drafts` are those of plan.items.
std::vector<Requirement> requirements_of(const Brief& brief, const std::vector<Draft>& drafts,
                                         const Plan& plan);

}  // namespace roomgen::design
