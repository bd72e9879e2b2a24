#pragma once

#include <string>
#include <vector>

#include "draft.h"
#include "roomgen/scene/requirement.h"

namespace roomgen {

/// The draft's requirements, checked on it as it stands now; those withdrawn stay so. Looks of things that are
/// as they were when the scene was opened keep their verdicts.
std::vector<RequirementVerdict> ledger_of(const Draft& draft);

/// Those of the requirements that were met and are not on the draft, in words; such as the edit itself is
/// about do not count.
std::vector<std::string> broken_requirements(const std::vector<RequirementVerdict>& before, const Draft& draft);

/// Relations of things that are still there which held before and do not on the draft, in words.
std::vector<std::string> broken_relations(const Scene& before, const Draft& draft);

/// Brings the draft's ledger up to date after all operations: what the edit asks for is added (source "edit"),
/// what it takes back is withdrawn, what went is counted no more, and everything is checked anew. Returns what
/// held before and does not now, in words.
std::vector<std::string> update_ledger(Draft& draft, const Scene& before);

}  // namespace roomgen
