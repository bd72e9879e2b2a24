#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/scene/room.h"

namespace roomgen {

// A dwelling is a list of rooms in one common frame. The walls of neighbours that face each other
// are one wall: their inner faces are wall_thickness apart, and a door in it is an opening of both
// rooms, each with the other's id in `leads_to`.

const Room* find_room(std::span<const Room> rooms, std::string_view id);

/// Every room is sound, ids are unique, no two rooms overlap, and every opening that leads to
/// another room meets an opening of that room that leads back.
Status check_dwelling(std::span<const Room> rooms);

/// The opening of the next room that is the other side of this one; null if there is none.
const Opening* other_side(std::span<const Room> rooms, const Room& room, const Opening& opening);

/// Part of a wall at which another room has its own: metres along the wall.
struct SharedStretch {
  std::size_t wall = 0;
  double from = 0.0;
  double to = 0.0;
  std::size_t room = 0;  ///< the neighbour
};

/// Where the walls of rooms[index] stand against those of other rooms: the outer face of the one is
/// the inner face of the other.
std::vector<SharedStretch> shared_stretches(std::span<const Room> rooms, std::size_t index);

/// Is there a way from outdoors through doors and passages to each room? The ids of those that
/// cannot be entered.
std::vector<std::string> rooms_without_access(std::span<const Room> rooms);

}  // namespace roomgen
