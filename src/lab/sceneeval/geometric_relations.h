#pragma once

#include "thing.h"

namespace roomgen::lab {

/// 1 for what stands, lies or hangs between two of the ends, seen from above: its centre between
/// theirs along the line through them and over neither; off that line by no more than half the
/// greater width of the two across it and half its own. SceneEval has no such function.
double between(const Thing& middle, std::span<const Thing> ends);

/// 1 for what stands in a vessel and rises out of it, a plant in a pot, where SceneEval's inside_of
/// asks for half of its box: the middle of its foot is in the anchor's box, above the ground that
/// the anchor stands on (a stool under a desk is not in it) and not on its top.
double stands_in(const Thing& target, const Thing& anchor);

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

/// Relations to walls, doors, windows and the floor that SceneEval has no function for, each in [0,
/// 1]; a relation holds above one half. Heights do not count for facing: who sits at a low desk
/// looks at the window all the same. Of several parts the best counts.

/// How squarely the front looks at what it meets of the opening, falling to 0 at 30 degrees as
/// SceneEval's face_to does; 0 where the strip as wide as the thing before its front misses it.
double face_opening(const Thing& thing, std::span<const Thing> openings);
/// As above, and how squarely to the wall itself: one half at 30 degrees, since there is always
/// some wall ahead.
double face_wall(const Thing& thing, std::span<const Thing> walls);
/// The share of the opening's width and of its height that the thing and it have in common, of what
/// the smaller of the two has; 0 when the thing is further than 0.15 m from the opening's plane.
double on_opening(const Thing& thing, std::span<const Thing> openings);
/// The share of a thing near the wall that is beyond the opening's side, left and right as seen
/// from the room, falling when it is further than 1.5 m from it.
double beside_opening(const Thing& thing, std::span<const Thing> openings, BoxSide side);
/// 1 for what stands on the floor or on a rug that lies there.
double on_floor(const Thing& thing);

}  // namespace roomgen::lab
