#pragma once

#include <span>

#include "base/random.h"
#include "brief/room_kinds.h"
#include "wall_stretch.h"

namespace roomgen::design {

// Doors and windows as a kind of room has them, where nobody asks for others.

/// The door of a room of that kind in a stretch of a wall, at one of its ends.
Opening usual_door(const RoomKind& kind, const WallStretch& stretch, double ceiling, bool at_from);
/// A window of the room's heights; `from` along its wall.
Opening usual_window(const RoomKind& kind, std::size_t wall, double from, double width,
                     double ceiling);
/// The width of a window; drawn.
double usual_window_width(const RoomKind& kind, bool wide, Random& random);

/// A door near the corner of a wall and windows in others: those that are glazed, then walls opposite
/// the door, then beside it.
void add_usual_openings(Room& room, const RoomKind& kind, std::span<const std::size_t> glazed,
                        int windows, bool wide_windows, Random& random);

/// Puts a door into the longest wall of a floor plan that has none. True if it did.
bool ensure_door(Room& room, const RoomKind& kind);

/// Puts windows into the longest walls without openings.
void add_windows(Room& room, const RoomKind& kind, int count, bool wide, Random random);

}  // namespace roomgen::design
