#pragma once

#include <vector>

#include "brief/brief.h"
#include "inventory.h"
#include "roomgen/scene/plan.h"

namespace roomgen::plan {

/// What a prompt asks for, and what each of its words was taken for.
struct LedgerOfPrompt {
  std::vector<Requirement> requirements;
  std::vector<Heard> heard;
};

/// Every clause of the prompt that can be checked: how many of each thing, how they look, how they
/// stand to others and to the room, what the room is like, what is not there. `drafts` are those of
/// plan.items; what the request gives besides wins over what the prompt says of the room's size.
LedgerOfPrompt ledger_of(const PlanRequest& request, const brief::Brief& brief,
                         const std::vector<Draft>& drafts, const Plan& plan);

}  // namespace roomgen::plan
