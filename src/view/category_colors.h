#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace roomgen {

using Rgb = std::array<std::uint8_t, 3>;  ///< sRGB

/// A colour for each category, no two the same. Those of rooms' parts are always the same; another category keeps
/// its own from scene to scene unless one earlier in the alphabet has it already.
std::map<std::string, Rgb> category_colors(const std::set<std::string>& categories);

}  // namespace roomgen
