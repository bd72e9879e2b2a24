#pragma once

#include <string>

#include "composition/composition.h"

namespace roomgen::plan {

/// How readily a composition is chosen by rules in a room of this kind, for a wish in lower case
/// (data/gathering.json): 0 where not at all, 1 where nothing is said.
double readiness(const composition::Composition& composition, const std::string& room,
                 const std::string& wish);

}  // namespace roomgen::plan
