#pragma once

#include <span>

#include "thing.h"

/// Relations to walls, doors, windows and the floor that SceneEval has no function for, each in [0,
/// 1]; a relation holds above one half. Heights do not count for facing: who sits at a low desk
/// looks at the window all the same. Of several parts the best counts.
namespace roomgen::lab {

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
