#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/scene/object.h"
#include "roomgen/scene/relation.h"

namespace roomgen::brief {

// What a prompt says of how many of something there are for others, of what there is nothing but, and of where a thing
// is not. Things are mentions, by their index in Brief::mentions, and what says them is one of Brief::heard.

inline constexpr std::size_t no_mention = static_cast<std::size_t>(-1);

/// "a lamp on each desk", "a plant in every corner": so many for each, its own.
struct SharedOut {
  std::size_t thing = no_mention;
  std::size_t owner = no_mention;  ///< none where it is a part of the room
  std::string place = {};          ///< "corner", "window", "door"
  int count = 1;                   ///< for each
  std::size_t word = no_mention;   ///< of Brief::heard: "each" itself
  std::size_t heard = no_mention;
};

/// "nothing else", "no other chairs", "no more than a laptop and a tray on the desk".
struct Limit {
  std::vector<std::size_t> allowed;  ///< what is there; empty: whatever the prompt names
  std::string category;              ///< nothing else of this kind; empty: of any
  std::size_t on = no_mention;       ///< nothing else on this thing
  std::optional<Mount> mount;        ///< nothing else on the walls, at the ceiling
  bool is_nothing = false;           ///< nothing there at all
  std::size_t heard = no_mention;

  bool is_of_room() const { return category.empty() && on == no_mention && !mount; }
};

/// "not next to the window": where none of a mention's things is.
struct Denial {
  std::size_t thing = no_mention;
  RelationKind kind = RelationKind::near;
  std::size_t target = no_mention;
  std::string part;  ///< of the room, where there is no target
  std::size_t heard = no_mention;
};

}  // namespace roomgen::brief
