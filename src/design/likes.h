#pragma once

#include "arrangement.h"
#include "holding.h"

namespace roomgen::design {

/// How much a place has of what a thing may like, in [0, 1].
double degree(const Sketch& sketch, const Placed& placed, Liking liking);

/// Share in [0, 1] of the floor around a thing that its use will want and that is still open.
double reserve_open(const Sketch& sketch, const Placed& placed, const Arrangement& arrangement);

/// Sum over the other things of the shares of their reserves that this place would take; things
/// named in `relations` are partners and do not mind.
double reserves_taken(const Sketch& sketch, const Placed& placed,
                      const std::vector<Relation>& relations);

/// True if a thing of its kind already stands on the same side of one of its targets.
bool on_crowded_side(const Sketch& sketch, const Placed& placed,
                     const std::vector<Relation>& relations);

/// Number of gaps to other solids and walls that are too wide to look joined and too narrow to
/// pass.
int slivers(const Sketch& sketch, const Placed& placed, const std::vector<Relation>& relations);

}  // namespace roomgen::design
