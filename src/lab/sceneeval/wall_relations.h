#pragma once

#include <span>

#include "thing.h"

namespace roomgen::lab {

/// Sides of things on walls that SceneEval's side_of cannot tell, since it asks that what is behind
/// the anchor is within its height, and what is above or below it within its depth. Each 1 or 0.
/// `walls` are those of the room.

/// The target hangs on a wall at whatever height, reaches as far as the anchor's back, and its
/// centre is within the anchor's width: a clock on the wall behind a bench.
double behind_on_wall(const Thing& target, const Thing& anchor, std::span<const Thing> walls);

/// The anchor hangs on a wall and is no deeper than 0.05 m, as mirrors, pictures and boards are.
/// The target's centre is above its upper edge (below its lower one); the target is no further than
/// 0.3 m from that wall, and the centre of the narrower of the two is within the wider: a plant
/// under a board.
double above_sheet(const Thing& target, const Thing& anchor, std::span<const Thing> walls);
double under_sheet(const Thing& target, const Thing& anchor, std::span<const Thing> walls);

}  // namespace roomgen::lab
