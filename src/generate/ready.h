#pragma once

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// A plan whose things can be placed one by one: settled (roomgen/design/designer.h), with its groups
/// completed, an item for each carrier where it is counted so, and everything as long as it is to hang down.
Plan ready(Plan plan, const KindTable& kinds);

/// What has a cord by nature, as kinds that hang from the ceiling have, is as long as it is to hang
/// down; other things keep their size and get wires.
void hang_down(PlanItem& item, const KindTable& kinds, const Room& room);

}  // namespace roomgen
