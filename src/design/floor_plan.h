#pragma once

#include <optional>

#include "brief.h"
#include "room_kinds.h"
#include "roomgen/base/random.h"
#include "roomgen/scene/room.h"

namespace roomgen::design {

/// Largest floor that is chosen rather than asked for.
inline constexpr double max_chosen_area = 48.0;

/// Width and depth for a room: what is asked, else chosen by its kind and large enough for
/// `furniture` square metres of things.
Vec2 choose_size(const RoomKind& kind, const Brief& brief, double scale, double furniture,
                 Random random);

/// A rectangle with one corner at the origin, a door near the corner of a wall and windows in
/// others.
Room make_room(const RoomKind& kind, const Vec2& size, int windows, bool wide_windows,
               Random random);

/// What the prompt says of materials, in place of what the room has.
void put_on(Room& room, const RoomMaterials& said);

/// Puts a door into the longest wall of a floor plan that has none. True if it did.
bool ensure_door(Room& room, const RoomKind& kind);

/// Puts windows into the longest walls without openings.
void add_windows(Room& room, const RoomKind& kind, int count, bool wide, Random random);

}  // namespace roomgen::design
