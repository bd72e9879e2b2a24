#pragma once

#include "brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// Ends the reading: numbers of uncounted things, small things for what stands on others, rugs
/// under what stands on them, "behind" turned into "in front of" where the one behind needs the
/// wall.
void settle(Brief& brief, const KindTable& table);

}  // namespace roomgen::brief
