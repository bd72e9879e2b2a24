#pragma once

#include "brief.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// How many there are of what is named in the plural without a number: one for each of the people, seats for the
/// tables, as many as what it is joined to ("eight desks and lamps"), else a few.
void settle_numbers(Brief& brief, const KindTable& table);

/// What stands on several things of a kind, named in the plural without a number: one on each.
void settle_numbers_on_carriers(Brief& brief);

}  // namespace roomgen::brief
