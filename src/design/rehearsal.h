#pragma once

#include <vector>

#include "arrangement.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen::design {

/// How a plan went in the sketch.
struct Rehearsal {
  std::vector<PlannedObject> missed;  ///< no place was found
  int broken = 0;                     ///< relations of the plan that did not hold
};

/// Places the things of a plan one after the other in a sketch, each exactly where it is advised to
/// go.
Rehearsal rehearse(const Plan& plan, const KindTable& table, const Arrangements& arrangements);

}  // namespace roomgen::design
