#pragma once

#include <vector>

#include "inventory.h"

namespace roomgen::plan {

/// Gives things that stand in a circle or an arc their places, and what they look at: the middle of the circle, with
/// what they stand around in it; of an arc what they face, at the middle of a wall, or else its own middle. The
/// circle is as wide as its things need to stand freely, closer where there is no room for that; where there is none
/// at all nothing is done. `items` are indices of those things in plan.items, whose drafts are `drafts`.
void lay_out_round(const std::vector<std::size_t>& items, const std::vector<Draft>& drafts, const KindTable& table,
                   Plan& plan);

/// Metres that a room must be wide and deep for the circles and arcs among what was asked for; 0 if there are none.
double side_for_round(const std::vector<Draft>& drafts, const KindTable& table);

}  // namespace roomgen::plan
