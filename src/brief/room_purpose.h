#pragma once

#include "brief.h"
#include "room_kinds.h"

namespace roomgen::brief {

/// "a bedroom for my twin boys", "my daughter's bedroom": by who a room is for it is another kind
/// of the sort that is named, where the table of rooms says so.
void refine_room_type(const language::Parse& parse, const RoomKinds& kinds, Brief& brief);

/// "where we knit": words of what a room is for that mean nothing else.
void hear_purposes(const RoomKinds& kinds, Brief& brief);

/// "somewhere to do yoga": the kind of room that the words of a prompt stand for; empty if none.
std::string room_by_purpose(const RoomKinds& kinds, const Brief& brief);

}  // namespace roomgen::brief
