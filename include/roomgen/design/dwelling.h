#pragma once

#include <optional>

#include "roomgen/base/result.h"
#include "roomgen/design/designer.h"
#include "roomgen/scene/dwelling.h"

namespace roomgen {

/// The plan of a dwelling, if the prompt asks for several rooms (docs/dwellings.md) and the request
/// gives neither a floor plan nor a size of one room; else nothing. The rooms are laid out by
/// rules, and the designer plans each of them with what the prompt says of it.
Result<std::optional<DwellingPlan>> plan_dwelling(const PlanRequest& request, Designer& designer);

}  // namespace roomgen
