#pragma once

#include <vector>

#include "inventory.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// Many of a kind that usually stand in rows (Arrangement::rows_from) do so where nothing is said of their place.
void fall_in_as_usual(std::vector<Draft>& drafts, const KindTable& table, const Arrangements& arrangements);

/// Gives the things of each formation of several rows their places and the wall that they face: a block in the middle
/// of the floor, or of the part of the room that is told, with the floor between them that their kind wants open
/// (closer where there is no room for it). One row alone is left to its relations. Circles and arcs: lay_out_round. `drafts` are those of plan.items.
void lay_out_formations(const std::vector<Draft>& drafts, const KindTable& table,
                        const Arrangements& arrangements, Plan& plan);

/// How many things stand in each row of so many.
std::size_t columns_of(const brief::Formation& formation, std::size_t count);

}  // namespace roomgen::plan
