#pragma once

#include <string>
#include <vector>

#include "brief/room_kinds.h"
#include "inventory.h"
#include "roomgen/compose/compose.h"

namespace roomgen::compose {

/// Opens an inventory up so that a room of `area` square metres can have as many seats, shelves and things, and as much
/// covered floor, as is asked for: what nobody counted may come in other numbers, and kinds that such rooms hold are added.
/// Numbers that somebody gave stay. Notes say what contradicts them.
void meet(const Complexity& asked, const design::RoomKind& room, double area, const std::vector<std::string>& excluded,
          const KindTable& kinds, std::vector<Stand>& stands, std::vector<std::string>& notes);

/// The floor on which the inventory would cover what is asked for; nothing if no occupancy is asked for. Of a room
/// that is to be fuller than rooms can be, the smallest that may do.
std::optional<double> floor_for(const Complexity& asked, const std::vector<Stand>& stands, const KindTable& kinds);

}  // namespace roomgen::compose
