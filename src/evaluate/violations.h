#pragma once

#include <vector>

#include "collision/solids.h"
#include "roomgen/evaluate/report.h"

namespace roomgen {

/// SceneReport::violations alone, with solids that remember what they were asked before: for whoever examines
/// one scene after another.
std::vector<Violation> violations(const Scene& scene, Solids& solids, const KindTable& categories);

}  // namespace roomgen
