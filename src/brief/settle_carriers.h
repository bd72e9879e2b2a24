#pragma once

#include "brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// What follows for the things that carry others, once settle_supports has found them: tops wide
/// enough, and the place on the floor that is said of what they carry.
void settle_carriers(Brief& brief, const KindTable& table);

}  // namespace roomgen::brief
