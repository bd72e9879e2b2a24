#pragma once

#include <vector>

#include "roomgen/scene/room.h"

namespace roomgen::lab {

/// North is +y and east is +x; the front is where the entrance is, the rear away from it, left and
/// right are those of who comes in. The middle lies between front and rear.
enum class RoomSide { north, south, east, west, front, rear, left, right, middle };

/// A part of a room at one side of it, or where two sides meet: "the northern third" is {{north},
/// 1/3}, "the north-east quarter" {{north, east}, 1/4}.
struct PartOfRoom {
  std::vector<RoomSide> sides;
  double share =
      0.5;  ///< of the room's length towards its only side; towards each of two it is one half
};

/// Is the point in that part of the room's bounding box, which for front, rear, left and right is
/// turned with the wall of the entrance? Of several entrances the first door that leads outdoors
/// counts, else the first; a room without one is entered from the south.
bool lies_in(const Vec2& point, const Room& room, const PartOfRoom& part);

}  // namespace roomgen::lab
