#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// A part of the room has no depth of its own.
inline constexpr double part_depth = 0.002;

/// The opening or wall that a name means ("door-0", "window-1", "wall-2"), as a thin footprint whose
/// front looks into the room. Empty if there is none.
std::optional<Footprint> part_of_room(const Room& room, std::string_view name);

/// The region of the floor's bounding box that a name means: a side (north is +Y, east +X) or two
/// that meet, or "middle" across the longer side, and how much of it: "north-half",
/// "south-two-thirds", "middle-third", "north-east-quarter" (half of either side). Empty if it is none.
std::optional<Footprint> region_of_room(const Room& room, std::string_view name);

/// All that region_of_room knows.
std::vector<std::string> region_names();

/// "wall-0", "wall-1", ...
std::vector<std::string> wall_names(const Room& room);

/// The target that is the wall that is nearest.
inline constexpr std::string_view nearest_wall = "wall";

/// Whether a relation may name it without naming an object: also "corner" and "wall".
bool is_part_of_room(const Room& room, std::string_view name);

}  // namespace roomgen
