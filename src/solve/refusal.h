#pragma once

#include "layout.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Why an object found no place among so many candidates, of which so many passed the cheap tests; for
/// people and for a model that shall answer again.
Error refusal(const Layout& layout, const PlacementTask& task, const Layout::Candidate& candidate,
              int candidates, int feasible);

}  // namespace roomgen
