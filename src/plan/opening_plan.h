#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "brief/opening_wish.h"
#include "brief/room_kinds.h"

namespace roomgen::design {

/// Gives the room the openings that are wished for, in walls of any outline. Of those that it has,
/// doors stay unless doors or passages are wished for, and windows come in addition; both may move
/// along their wall or to another. What does not fit is made narrower, put elsewhere or left out,
/// which the notes say. Afterwards the room is sound (check()) and has an entrance, if any wall
/// takes one.
void plan_openings(Room& room, const RoomKind& kind, const std::vector<OpeningWish>& wishes,
                   Random random, std::vector<std::string>& notes);

}  // namespace roomgen::design
