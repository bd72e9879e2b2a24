#pragma once

#include <string>
#include <vector>

#include "composition/composition.h"

namespace roomgen::plan {

/// How readily a composition is chosen by rules in a room of this kind, for a wish in lower case
/// (data/gathering.json): 0 where not at all, 1 where nothing is said.
double readiness(const composition::Composition& composition, const std::string& room,
                 const std::string& wish);

/// Kinds that rows of seats look at where nothing else is said, the likeliest first.
const std::vector<std::string>& usual_foci();

}  // namespace roomgen::plan
