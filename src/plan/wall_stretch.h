#pragma once

#include <cstddef>
#include <vector>

#include "roomgen/scene/room.h"

namespace roomgen::plan {

// What openings keep clear of, and what they need at least, metres.
inline constexpr double corner_offset = 0.12;  ///< of a door from the wall beside it: room for frame and hand
inline constexpr double least_gap = 0.15;      ///< between openings that share a stretch, and to its ends
inline constexpr double between_openings = 0.1;  ///< of wall beside one that is already there
inline constexpr double window_margin = 0.35;  ///< of a window from the corners
inline constexpr double least_window = 0.4;    ///< width

/// A part of a wall where openings may be, metres along it.
struct WallStretch {
  std::size_t wall = 0;
  double from = 0.0, to = 0.0;

  double length() const { return to - from; }
};

/// The walls of a room, each as a whole.
std::vector<WallStretch> whole_walls(const Room& room);
/// What the room's openings leave of its walls.
std::vector<WallStretch> bare_walls(const Room& room);

/// Takes what lies between `from` and `to` along a wall out of stretches.
void cut(std::vector<WallStretch>& stretches, std::size_t wall, double from, double to);

/// The opening with its middle at that part of the stretch, from 0, its beginning, to 1, but `offset` away from
/// both ends where there is room for that.
Opening moved_to(Opening opening, const WallStretch& stretch, double middle, double offset);

}  // namespace roomgen::plan
