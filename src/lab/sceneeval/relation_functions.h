#pragma once

#include <span>
#include <string_view>

#include "relation_words.h"
#include "thing.h"

namespace roomgen::lab {

/// A room with the surfaces of its walls, doors and windows.
struct RoomSurfaces {
  explicit RoomSurfaces(const Room& of) : room(of), parts(room_things(of)) {}
  Room room;
  RoomThings parts;
};

/// Is there a function of that name between things, or of a thing to its room?
bool is_relation_function(std::string_view name);

/// In [0, 1]; the relation holds above one half. `around` is the room of the anchor.
double evaluate(const RelationFunction& function, std::span<const Thing> targets,
                const Thing& anchor, const RoomSurfaces& around);

/// Of a thing to its room; `part` is the word for the part of the room ("wall", "door").
double evaluate(const RelationFunction& function, const Thing& thing, std::string_view part,
                const RoomSurfaces& around);

}  // namespace roomgen::lab
