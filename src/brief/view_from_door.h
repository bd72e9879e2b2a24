#pragma once

#include <string>
#include <vector>

#include "prompt_reading.h"

namespace roomgen::brief {

/// The walls to the left and the right of who comes in.
inline constexpr int left_wall = 3, right_wall = 1;

/// "as you come in", "when you enter": the words, which are heard as the room's.
std::vector<language::Run> views_from_door(PromptReading& reading);

/// "the back wall", "in the left half", "far corner": sides as who comes in sees them, not those of a map.
bool tells_sides_from_door(const PromptReading& reading);

/// The half of the room at a wall.
std::string half_at(int wall);

}  // namespace roomgen::brief
