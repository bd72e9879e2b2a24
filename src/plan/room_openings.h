#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/random.h"
#include "brief/opening_wish.h"
#include "brief/room_kinds.h"
#include "roomgen/scene/room.h"

namespace roomgen::plan {

/// What a room's doors, windows and passages shall be.
struct RoomOpenings {
  int windows = 0;              ///< as the room's kind has them
  bool counted = false;         ///< somebody asked for so many
  bool wide = false;            ///< wider than usual
  std::vector<brief::OpeningWish> wishes = {};   ///< for what the prompt says more of
  bool front_door = false;      ///< in the front wall, where there is room for it there
};

/// Gives a room without openings what its kind has and what is wished for, in walls of any outline; `glazed`
/// walls, as those of a bay, are windows. Doors or passages that are wished for take the place of the usual
/// door, windows come in addition. What does not fit is made narrower, put elsewhere or left out, which the
/// notes say. Afterwards the room is sound (check()) and has an entrance, if any wall takes one.
void plan_openings(Room& room, const brief::RoomKind& kind, const std::vector<std::size_t>& glazed,
                   const RoomOpenings& openings, Random& random, std::vector<std::string>& notes);

/// Puts a door into a floor plan that has none, which the notes then say.
void ensure_door(Room& room, const brief::RoomKind& kind, std::vector<std::string>& notes);

}  // namespace roomgen::plan
