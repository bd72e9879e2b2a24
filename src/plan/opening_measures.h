#pragma once

namespace roomgen::design {

// What doors and windows keep clear of, metres.
inline constexpr double corner_offset = 0.12;  ///< of a door from the wall beside it: room for frame and hand
inline constexpr double under_ceiling = 0.1;   ///< of a window's head

}  // namespace roomgen::design
