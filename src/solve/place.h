#pragma once

#include <span>

#include "base/random.h"
#include "layout.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/problem.h"
#include "roomgen/solve/solve.h"

namespace roomgen {

/// Finds the pose for one object: propose, score, rank, fuse, and take the best candidate that the
/// meshes and everybody's reachability allow. `later` are tasks still to come: those that depend on
/// this object are looked after. Does not change the layout in the end. Fails with a reason for
/// people when nothing is feasible, and when it is cancelled.
Result<Placement> place(Layout& layout, const PlacementTask& task,
                        std::span<const PlacementTask> later, const PlaceOptions& options,
                        Random& random);

/// The task with the soft constraint that leads the first way of its kind which can be named, as one of
/// its relations, and no longer `usual`: for searches that move many things.
PlacementTask with_leading_habit(const Layout& layout, PlacementTask task);

/// place() for what goes where its kind usually does (PlacementTask::usual): of the ways of its kind that
/// can be named in the room, the first whose leading constraint can hold; there the pose that loses the
/// fewest of its own constraints and is preferred most. The object gets the soft constraints that hold
/// there as relations of its own, behind those that it has.
Result<Placement> place_usually(Layout& layout, const PlacementTask& task,
                                const Arrangement& arrangement, const PlaceOptions& options,
                                Random& random);

}  // namespace roomgen
