#pragma once

#include <vector>

#include "brief/brief.h"
#include "design/plan_reply.h"
#include "plan/inventory.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::book {

/// A design with what a wish asks for in it. Drafts of the wish's things have its mentions, those
/// of the design further numbers.
struct Merged {
  std::vector<plan::Draft> drafts;
  std::vector<PlanGroup> groups;
};

/// Makes the design's own things what the wish asks for: as many, that look so, of that size, with
/// its relations above the design's. What the wish forbids goes, with what stands on it. What the
/// design does not have is added, in no group yet.
Merged merge(design::PlanParts parts, const brief::Brief& brief, const KindTable& kinds);

}  // namespace roomgen::book
