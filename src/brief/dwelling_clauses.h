#pragma once

#include <vector>

#include "dwelling_rooms.h"

namespace roomgen::brief {

/// Tokens of a prompt from one to before another.
struct Stretch {
  std::size_t begin = 0, end = 0;
};

/// What is said of each room: each clause goes to the room that it is said of, one that names none
/// to the room where its things usually stand.
std::vector<std::vector<Stretch>> share_clauses(const DwellingText& text,
                                                const std::vector<NamedRoom>& names,
                                                const std::vector<FoundRoom>& rooms,
                                                const RoomKinds& kinds,
                                                const KindTable& table);

}  // namespace roomgen::brief
