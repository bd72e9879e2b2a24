#pragma once

#include <vector>

#include "inventory.h"

namespace roomgen::plan {

/// Where a formation stands, and its focus: what its things look at or stand around, the screen of rows of seats, the
/// fireplace of a half circle of armchairs.

/// The part of the floor that is told, else all of it.
Bounds2 floor_of(const Draft& draft, const Room& room);

/// Whether anything was named that they face.
bool faces_something(const Draft& draft);

/// The draft that they face or stand around, if it is one thing; null if there is none.
const Draft* focus_of(const Draft& draft, const std::vector<Draft>& drafts);

/// How little a wall is one to look at, for choosing the least: those told, of the things or of their focus, are far below
/// 0; the front wall is below where other things are told to be at the front; one with windows or doors is above.
double cost_of_facing(const Room& room, std::size_t wall, const Draft& draft, const std::vector<Draft>& drafts);

/// Stands what is looked at before the middle of a wall that things around `center` look at, unless it was told where;
/// what stands on the floor so far from the wall, metres.
void put_focus_at_wall(const Draft& audience, std::size_t wall, const Vec2& center, double off_wall,
                       const std::vector<Draft>& drafts, Plan& plan);

}  // namespace roomgen::plan
