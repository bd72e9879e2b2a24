#pragma once

#include <functional>

#include "learned_place.h"

namespace roomgen::book {

/// Puts "{wood}" and the like in the place of a palette's words, where these stand alone; the
/// longest first.
std::function<std::string(std::string)> with_roles(const Room& room);

/// The "room" of a design: type, height, surfaces, light, style and palette.
Json told_room(const Room& room, const std::function<std::string(std::string)>& worded);

/// Its "openings": what is near a corner keeps its distance to that.
Json told_openings(const Room& room);

}  // namespace roomgen::book
