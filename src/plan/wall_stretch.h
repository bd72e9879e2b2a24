#pragma once

#include <cstddef>
#include <vector>

#include "roomgen/scene/room.h"

namespace roomgen::design {

// What doors and windows keep clear of, and what they need at least, metres.
inline constexpr double corner_offset = 0.12;  ///< of a door from the wall beside it: room for frame and hand
inline constexpr double door_margin = 0.1;     ///< of wall beyond a door's width: its leaf or frame
inline constexpr double window_margin = 0.35;  ///< of a window from the corners
inline constexpr double under_ceiling = 0.1;   ///< of a window's head
inline constexpr double least_window = 0.4;    ///< width
inline constexpr double least_height = 0.3;    ///< of a window

/// A part of a wall where openings may be, metres along it.
struct WallStretch {
  std::size_t wall = 0;
  double from = 0.0, to = 0.0;

  double length() const { return to - from; }
};

WallStretch whole_wall(const Room& room, std::size_t wall);

/// Takes what lies between `from` and `to` out of stretches of one wall.
void cut(std::vector<WallStretch>& stretches, double from, double to);

/// Where an opening begins that stands at the one or the other end of a stretch, a corner's offset
/// away; in a stretch that is hardly wider both are its middle.
struct StretchEnds {
  double low = 0.0, high = 0.0;
};
StretchEnds ends_for(const WallStretch& stretch, double width);

/// Where an opening begins that stands in the middle of the stretch.
double middle_for(const WallStretch& stretch, double width);

/// The width of a door in a stretch: the usual one, or nearly all of a shorter stretch.
double door_width(double usual, const WallStretch& stretch);

Opening opening_at(OpeningType type, std::size_t wall, double from, double width, double head);
/// Moves an opening along its wall.
void move_to(Opening& opening, double from);

}  // namespace roomgen::design
