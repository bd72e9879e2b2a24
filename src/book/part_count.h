#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/plan.h"

namespace roomgen::book {

/// Sets a group, by its parameters or by its own definition, so that it has as near to `number`
/// things of the part as it can; `items` are those of the group. Comes back with how many things of
/// each part it has then.
std::map<std::string, int> set_part_count(PlanGroup& group, const std::vector<PlanItem>& items,
                                          const std::string& part, int number,
                                          const KindTable& kinds);

}  // namespace roomgen::book
