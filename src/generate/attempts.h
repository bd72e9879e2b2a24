#pragma once

#include "roomgen/solve/solve.h"
#include "workplace.h"

namespace roomgen {

/// Tries to find an object a place by all means: each asset, for the first one again with other
/// answers, room made by others, then a repair. Says in `step` what was tried, and why it failed if
/// it did.
void try_all(Work& work, const PlannedObject& planned, Step& step);

/// An attempt with an asset as the answer says, before its outcome is known.
Attempt begun(const AssetInfo& asset, const PlaceAdvice& answer);
/// What the solver weighed, for the attempt's record.
void note(const Placement& placement, Attempt& attempt);

/// One attempt: an asset as somebody says. Puts the object into the room if it finds a place; else
/// Attempt::refused says why not. An error if it cannot even be tried.
Result<Attempt> try_to_place(Work& work, const PlannedObject& planned, const AssetInfo& asset,
                             const PlaceAdvice& advice, std::size_t refused, PlacementTask& task);

/// Moves what stands for those that do not, and for constraints that do not hold.
void improve_all(Work& work, int rounds, Improvement mode);

/// Is the object the anchor of a group that has not been tried yet?
bool begins_group(const Work& work, const PlannedObject& planned);

/// Places the group of an anchor as one thing; the others take their places when their turn comes.
/// `asset` is that of the anchor. Fails with what is in the way.
Result<Placement> place_with_group(Work& work, const PlannedObject& planned, PlacementTask& task,
                                   const PlaceOptions& options);

/// The task of an anchor with all that stands about it in the first way of its group; else as it
/// is.
PlacementTask with_companions(Work& work, const PlannedObject& planned, const PlacementTask& task);

/// The group of an anchor that found no place: its things stand for themselves.
void fall_apart(Work& work, const PlannedObject& planned, const PlacementTask& task);

/// The group that stands around an anchor gives up its places: it stands anew with it.
void disband(Work& work, const std::string& anchor);

/// Puts a thing at its place in its group, or says in `step` that the group had none for it. False
/// where it has to find a place for itself.
bool take_place_in_group(Work& work, const PlannedObject& planned, Step& step);

}  // namespace roomgen
