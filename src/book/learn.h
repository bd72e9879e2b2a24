#pragma once

#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::book {

/// A finished room as a design (docs/designs.md): its groups are found and told so that they adapt,
/// what stands keeps its distance to what it is near, small things may be left out first. A room
/// that is no rectangle is told by its box. The room must be sound and no dwelling.
Json design_of(const Scene& scene, const KindTable& kinds, const LearnOptions& options);

}  // namespace roomgen::book
