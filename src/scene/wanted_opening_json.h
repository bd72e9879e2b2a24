#pragma once

#include <vector>

#include "base/json_reader.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// "openings" of a plan. Walls and places along them are given as the file has the corners of the
/// room, and kept as the room has them. What cannot be is left open or left out, with a remark.
std::vector<WantedOpening> read_wanted_openings(const JsonReader& json,
                                                const std::vector<Vec2>& corners, const Room& room);
Json to_json(const std::vector<WantedOpening>& openings);

}  // namespace roomgen
