#pragma once

#include <optional>
#include <string_view>

namespace roomgen {

/// What carries a thing; `surface` is the top of another thing.
enum class Mount { floor, wall, ceiling, surface };

std::string_view name(Mount mount);
/// Null if the text is none of floor, wall, ceiling, surface.
std::optional<Mount> parse_mount(std::string_view text);

/// How a thing fills its box and whether it has a front.
struct Traits {
  bool front = true;   ///< has a front side; without it any yaw is as good
  bool flat = false;   ///< a rug: other things stand on it
  bool round = false;  ///< covers the ellipse inscribed in its rectangle

  bool operator==(const Traits&) const = default;
};

}  // namespace roomgen
