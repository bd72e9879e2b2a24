#pragma once

#include <string>
#include <vector>

#include "plan_answers.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/plan.h"

namespace roomgen::design {

/// The groups of an answer (docs/groups.md): compositions of data/compositions by name, set by "with", repeated,
/// with further things; or the answer's own, of things that each say where they are ("around table"). `drafts`
/// are those of read_reply_items(): those of groups get the names of their parts. What cannot be so is
/// noted with its place in the answer, and its things stand for themselves.
std::vector<PlanGroup> read_reply_groups(const Json& json, const ItemLexicon& lexicon,
                                         std::vector<plan::Draft>& drafts,
                                         std::vector<std::string>& repairs);

}  // namespace roomgen::design
