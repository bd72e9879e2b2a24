#pragma once

#include "clause_parts.h"

namespace roomgen {

/// Rooms of a dwelling that are named there: "the bedroom", "bedroom-1", "both bedrooms", "every room", "the whole flat";
/// with several of a name where one is meant. Nothing in a scene of one room.
struct SpokenRooms {
  Ids ids;
  bool plural = false;  ///< all of them are meant
  std::size_t begin = 0;  ///< behind "the", "both"
  std::size_t end = 0;
};
std::optional<SpokenRooms> rooms_named_at(const EditText& text, std::size_t at);

/// "in the bedroom", "to the living room", "into bedroom-1": the id of a room of the dwelling. not_understood, with the
/// choices, where there are several of that name; nothing in a scene of one room.
MayRead<std::string> in_room_at(const EditText& text, std::size_t at);

/// That words may mean any of these rooms.
Error several_rooms(const std::string& words, const Ids& rooms);

}  // namespace roomgen
