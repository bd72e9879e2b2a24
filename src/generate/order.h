#pragma once

#include <optional>
#include <string>
#include <vector>

#include "build_state.h"
#include "workplace.h"

namespace roomgen {

/// The one that the designer asked for, else the first in the plan's order.
std::optional<PlannedObject> next_of(const BuildState& state);

/// Of those left, besides the one at work, what may come next: what stands on others waits for all
/// that might carry it.
std::vector<std::string> may_come_next(const Work& work);

}  // namespace roomgen
