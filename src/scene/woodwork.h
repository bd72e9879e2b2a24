#pragma once

#include "room_shell.h"
#include "roomgen/geometry/model.h"

namespace roomgen::detail {

/// Frame, leaf or pane of an opening in a wall of this height; no parts if the options ask for
/// none.
Model opening_woodwork(const Room& room, const Opening& opening, double height,
                       const ShellOptions& options);
/// A board along a wall, metres.
struct Board {
  double low = 0.0, high = 0.0;  ///< over the floor
  double depth = 0.0;            ///< that it stands out
};
/// Wherever the wall is solid from its lower to its upper edge.
Mesh wall_board(const Room& room, std::size_t wall, double height, const Board& board);
/// The one along the foot of a wall.
Mesh skirting_board(const Room& room, std::size_t wall, double height);
/// White paint of frames and boards.
Material woodwork_paint();

}  // namespace roomgen::detail
