#pragma once

#include <span>
#include <string>
#include <string_view>

#include "relation_functions.h"

namespace roomgen::lab {

/// The rooms that a requirement can mean by a word such as "kitchen" or "bedroom_2": those of a
/// dwelling that are of that kind, or every room if there are none or it is a single one.
class NamedRooms {
 public:
  NamedRooms(std::string_view word, std::span<const RoomSurfaces* const> rooms);

  bool contain(const Room& room) const { return !any_ || is_named(room); }

 private:
  bool is_named(const Room& room) const;

  std::string kind_;
  bool any_;
};

}  // namespace roomgen::lab
