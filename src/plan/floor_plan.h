#pragma once

#include <optional>

#include "base/random.h"
#include "brief/brief.h"
#include "brief/outline.h"
#include "brief/room_kinds.h"
#include "library/style_words.h"
#include "roomgen/scene/room.h"

namespace roomgen::design {

/// Largest floor that is chosen rather than asked for.
inline constexpr double max_chosen_area = 48.0;

/// Width and depth for a room: what is asked, else chosen by its kind and large enough for
/// `furniture` square metres of things.
Vec2 choose_size(const RoomKind& kind, const Brief& brief, double scale, double furniture,
                 Random random);

/// The floor that the prompt asks for. `chosen` is its box if that is asked for, else that of a
/// rectangle of the area that it shall have. Fills `notes` with what had no place.
Outline choose_outline(const Brief& brief, const Vec2& chosen, bool is_box,
                       std::vector<std::string>& notes, Random random);

/// A room of that floor with a door near the corner of a wall and windows in others: those that are
/// glazed, then walls opposite the door, then beside it.
Room make_room(const RoomKind& kind, const Outline& outline, int windows, bool wide_windows,
               Random random);

/// Walls and floor of a style; floors that get wet keep their tiles.
void put_on(Room& room, const StyleMeaning& style, Random random);
/// What the prompt says of materials, in place of what the room has.
void put_on(Room& room, const RoomMaterials& said);

/// The wall of a polygon that a rectangle's side stands for: 0 the front wall (lower on the plan),
/// then counter-clockwise 1 the right, 2 the back, 3 the left one; where several look there, the
/// longest.
std::size_t wall_on_side(const Polygon& polygon, std::size_t side);
/// What the prompt calls a part of the room ("wall-3": the left wall), as the room has it.
std::string part_of(const Room& room, const std::string& said);

/// Puts a door into the longest wall of a floor plan that has none. True if it did.
bool ensure_door(Room& room, const RoomKind& kind);

/// Puts windows into the longest walls without openings.
void add_windows(Room& room, const RoomKind& kind, int count, bool wide, Random random);

}  // namespace roomgen::design
