#pragma once

#include "workplace.h"

namespace roomgen {

/// Is the object the anchor of a group that has not been tried yet?
bool begins_group(const Work& work, const PlannedObject& planned);

/// Places the group of an anchor as one thing; the others take their places when their turn comes.
/// `asset` is that of the anchor. Fails with what is in the way.
Result<Placement> place_with_group(Work& work, const PlannedObject& planned, PlacementTask& task);

/// The group of an anchor that found no place: its things stand for themselves.
void fall_apart(Work& work, const PlannedObject& planned, const PlacementTask& task);

/// Puts a thing at its place in its group, or says in `step` that the group had none for it. False
/// where it has to find a place for itself.
bool take_place_in_group(Work& work, const PlannedObject& planned, Step& step);

}  // namespace roomgen
