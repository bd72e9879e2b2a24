#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace roomgen::shape {

/// sRGB, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// "#b58a58", "#abc" or a name: the common ones of CSS and those of woods and metals.
std::optional<Rgb> parse_color(std::string_view text);
std::vector<std::string_view> color_names();

}  // namespace roomgen::shape
