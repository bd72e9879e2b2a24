#pragma once

#include <string>
#include <vector>

#include "book.h"
#include "brief/brief.h"
#include "roomgen/scene/plan.h"

namespace roomgen::book {

/// The kind of room that a wish is taken for.
std::string room_type_of(const PlanRequest& request, const brief::Brief& brief);

/// The plan for a request whose prompt says what `brief` holds, by the design that serves it best,
/// by seed one of those that serve it about as well. The design is fitted to the room that is given
/// or wished for, else the room to it; what the wish asks for is merged into it. Each plan has a
/// dry run: where things find no place, the room grows or what may be left out goes. Fails with
/// too_small where nothing that makes the room what it is called finds a place.
Result<Plan> plan_by_book(const PlanRequest& request, const brief::Brief& brief,
                          const std::vector<const Design*>& designs);

}  // namespace roomgen::book
