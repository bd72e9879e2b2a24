#pragma once

#include <string>
#include <vector>

#include "brief/room_kinds.h"
#include "inventory.h"
#include "roomgen/lab/compose.h"

namespace roomgen::lab::compose {

/// The middle of a range of shares, of which nothing is more than all.
double middle_share(const Range& range);

/// What numbers are met with: the kinds that such rooms hold, and those that nobody wants there.
struct Means {
  const brief::RoomKind& room;
  const std::vector<std::string>& excluded;
  const KindTable& kinds;
};

/// Opens an inventory up so that there can be as many seats, shelves and things as are asked for: what nobody counted
/// may come in other numbers, and kinds are added. Numbers that somebody gave stay. Notes say what contradicts them.
void meet_numbers(const Complexity& asked, const Means& means, std::vector<Stand>& stands,
                  std::vector<std::string>& notes);
/// Opens it up so that as much of a floor of `area` square metres can be covered as is asked for.
void meet_occupancy(const Complexity& asked, const Means& means, double area, std::vector<Stand>& stands);

/// The floor on which the inventory, open to numbers, would cover what is asked for; nothing if no occupancy is asked
/// for. Of a room that is to be fuller than rooms can be, the smallest that may do.
std::optional<double> floor_for(const Complexity& asked, const std::vector<Stand>& stands, const KindTable& kinds);

}  // namespace roomgen::lab::compose
