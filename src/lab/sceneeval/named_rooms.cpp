#include "named_rooms.h"

#include <algorithm>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

// "bedroom_2" is a bedroom.
std::string kind_of_room(std::string_view word) {
  std::vector<std::string> pieces = words(word);
  if (pieces.size() > 1 && pieces.back().find_first_not_of("0123456789") == std::string::npos)
    pieces.pop_back();
  return join(pieces, " ");
}

}  // namespace

NamedRooms::NamedRooms(std::string_view word, std::span<const RoomSurfaces* const> rooms)
    : kind_(kind_of_room(word)),
      any_(std::any_of(rooms.begin(), rooms.end(),
                       [&](const auto* around) { return is_named(around->room); })) {}

bool NamedRooms::is_named(const Room& room) const {
  return !room.id.empty() && room.type == kind_;  // the room of no dwelling has no id
}

}  // namespace roomgen::lab
