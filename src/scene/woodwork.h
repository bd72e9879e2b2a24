#pragma once

#include "room_shell.h"
#include "roomgen/geometry/model.h"

namespace roomgen::detail {

/// Frame, leaf or pane of an opening in a wall of this height; no parts if the options ask for
/// none.
Model opening_woodwork(const Room& room, const Opening& opening, double height,
                       const ShellOptions& options);
/// The board along the foot of a wall.
Mesh skirting_board(const Room& room, std::size_t wall, double height);
/// White paint of frames and boards.
Material woodwork_paint();

}  // namespace roomgen::detail
