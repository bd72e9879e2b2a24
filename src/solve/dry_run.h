#pragma once

#include <functional>
#include <vector>

#include "arrangement.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// How a plan went with boxes in the place of meshes.
struct DryRun {
  std::vector<PlannedObject> missed;  ///< found no place
  int broken = 0;                     ///< relations of the plan that did not hold
};

/// Places the things of a plan one after the other, as the step loop does for a designer that names no
/// places, but as boxes and without repair: nearly always what fits here fits with meshes. Ends with what it
/// has as soon as `is_hopeless` says so of that; it is asked whenever something went wrong.
DryRun dry_run(const Plan& plan, const KindTable& categories, const Arrangements& arrangements,
               const std::function<bool(const DryRun&)>& is_hopeless = {});

}  // namespace roomgen
