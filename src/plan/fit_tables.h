#pragma once

#include <vector>

#include "brief/brief.h"
#include "inventory.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::plan {

/// Makes the tables that the prompt asks for, without saying how large, fit the seats it asks for.
void fit_tables(std::vector<Draft>& drafts, const brief::Brief& brief, const KindTable& table);

}  // namespace roomgen::plan
