#pragma once

#include <vector>

#include "arrangement.h"
#include "roomgen/scene/category.h"
#include "roomgen/scene/plan.h"

namespace roomgen::design {

/// Places the things of a plan one after the other in a sketch, each exactly where it is advised to
/// go. Returns those for which no place was found.
std::vector<PlannedObject> rehearse(const Plan& plan, const CategoryTable& table,
                                    const Arrangements& arrangements);

}  // namespace roomgen::design
