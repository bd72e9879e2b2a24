#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// The sides of a rectangle by the compass, as walls_on_side() counts them: "south" is 0.
std::string_view compass_name(int side);
/// Nothing: it names no side.
std::optional<int> compass_side(std::string_view name);

/// The walls of a polygon that look to a direction (at most 45 degrees off), the longest first.
std::vector<std::size_t> walls_towards(const Polygon& polygon, const Vec2& direction);

/// The same for a side of a rectangle: 0 the front wall (lower on the plan), then counter-clockwise
/// 1 the right, 2 the back, 3 the left one.
std::vector<std::size_t> walls_on_side(const Polygon& polygon, int side);

/// The one wall that stands for a side: where several look there, the longest; where none does, the
/// one that comes nearest.
std::size_t wall_on_side(const Polygon& polygon, std::size_t side);

/// The walls that a name means ("wall-2", "north", "accent"), the longest first; else none.
std::vector<std::size_t> walls_named(const Room& room, std::string_view name);

/// Could it be the name of walls in some room?
bool is_wall_name(std::string_view name);

}  // namespace roomgen
