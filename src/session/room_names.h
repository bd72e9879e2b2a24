#pragma once

#include "clause_parts.h"

namespace roomgen {

/// "in the bedroom", "to the living room", "into bedroom-1": the id of a room of the dwelling. not_understood, with the
/// choices, where there are several of that name; nothing in a scene of one room.
MayRead<std::string> in_room_at(const EditText& text, std::size_t at);

}  // namespace roomgen
