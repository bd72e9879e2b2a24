#pragma once

#include "place.h"

namespace roomgen {

/// place() for what goes where its kind usually does (PlacementTask::usual): of the ways of its kind that
/// can be named in the room, the first whose leading constraint can hold; there the pose that loses the
/// fewest of its own constraints and is preferred most. The object gets the soft constraints that hold
/// there as relations of its own, behind those that it has.
Result<Placement> place_usually(Layout& layout, const PlacementTask& task,
                                const Arrangement& arrangement, const PlaceOptions& options,
                                Random& random);

}  // namespace roomgen
