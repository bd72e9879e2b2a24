#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brief/brief.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/requirement.h"

namespace roomgen::plan {

/// A requirement, and which of Brief::heard say it.
struct SaidClause {
  Requirement requirement;
  std::vector<std::size_t> words;
};

/// What is asked of the room itself: its kind, sides, shape, openings, seats, style, and what
/// nothing in it can show. `type`: what the plan calls the room.
std::vector<SaidClause> clauses_of_room(const brief::Brief& brief, const PlanRequest& request,
                                        const std::string& type);

/// The words that were heard as that and are said of no thing, by Brief::heard.
std::vector<std::size_t> words_heard_as(const brief::Brief& brief, Heard::As as,
                                        const std::string& word);

}  // namespace roomgen::plan
