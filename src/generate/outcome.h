#pragma once

#include "build_state.h"
#include "workplace.h"

namespace roomgen {

/// All that is known of a room in this state: the scene in the plan's order with coordinates as a file holds
/// them, what found no place, the requirements' verdicts, figures.
Generation outcome(const Workplace& place, const BuildState& state);

}  // namespace roomgen
