#pragma once

#include <span>

#include "base/random.h"
#include "layout.h"
#include "roomgen/base/cancel.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

struct ArrangeOptions {
  double pitch = 0.20;  ///< of the grid, for things that need not stand at a wall
  int tries = 15;       ///< searches from the start
  int choices = 12;     ///< poses tried for one thing in one situation
  double noise = 0.3;   ///< added to degrees, uniform in [0, noise): makes the tries differ
  bool first_without_noise = true;
  CancelToken cancel;
};

/// Places all of `tasks` so that every constraint of each holds, or none of them. Each task comes
/// after those that its constraints name; what the layout holds already stays where it is.
///
/// A depth-first search over the meaningful poses, best degree first. The next thing is the one
/// with the fewest poses left, and a pose that leaves another thing none is not taken (forward
/// checking, Haralick and Elliott 1980). When a thing finds no pose, the search goes back to the
/// last one that was in its way or that its constraints name, not merely to the one before
/// (conflict-directed backjumping, Prosser 1993). A try that takes too long gives way to another
/// one (Luby, Sinclair and Zuckerman 1993).
bool arrange(Layout& layout, std::span<const PlacementTask* const> tasks,
             const ArrangeOptions& options, Random& random);

}  // namespace roomgen
