#pragma once

#include <cstddef>
#include <span>

#include "collision/support_surfaces.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// Did somebody say how wide or deep the thing shall be?
bool is_size_told(const PlanItem& item, const Kind& category);

/// How much smaller a thing becomes to fit one of the surfaces, at least 0.6: a cushion comes in many
/// sizes. Less with each refusal.
double shrink_factor(const Object& object, std::span<const SupportSurface> surfaces,
                     std::size_t refused);

}  // namespace roomgen
