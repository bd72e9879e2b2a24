#pragma once

#include <vector>

#include "inventory.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// Puts items in the order of placement (stages of the arrangements, large before small, what is
/// demanded of others after them) and turns demands into relations between ids. Items of several
/// things whose targets are several are split, so that each thing gets its own target. Demands that
/// depend on each other in a circle are dropped and noted. The answer are the drafts in the order
/// of plan.items.
std::vector<Draft> order_items(std::vector<Draft> drafts, const KindTable& table,
                               const Arrangements& arrangements, Plan& plan);

}  // namespace roomgen::plan
