#pragma once

#include <set>
#include <string>

#include "draft.h"

namespace roomgen {

/// A room as it will be, and what goes along with it.
struct RoomChange {
  Room room;
  std::set<std::string> along = {};  ///< ids of what stands at a wall that moves, or hangs from it
  Vec2 by = Vec2::Zero();            ///< how they go
};

/// Puts the changed room into the draft. What stood to the things that go along follows them; all else keeps its
/// pose, unless it would be where nothing may stand any more (docs/constraints.md, "Valid"): then it moves as
/// little as can be, with its relations. Whatever moved is in Draft::repairs.
Status change_room(Draft& draft, const RoomChange& change);

}  // namespace roomgen
