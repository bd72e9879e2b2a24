#pragma once

#include <string>

#include "design.h"

namespace roomgen::book {

/// Mirrors and turns what a design says of walls, openings and places, whose formulas are numbers
/// by now, into the room's frame. `size` is that of the room before the turn. Errors name the
/// source.
Status lay(const std::string& source, const Setting& setting, const Vec2& size, Json& answer);

}  // namespace roomgen::book
