#pragma once

#include "workplace.h"

namespace roomgen {

/// What RoomBuilder::check_kind() says of a room that has come so far.
Status check_kind(const Workplace& place, const BuildState& state);

/// Up to `count` places for an object as things stand: the one that try_all() would take first,
/// then the best of the rest.
Result<Proposal> propose_places(Work& work, const PlannedObject& planned, std::size_t count);

/// Puts the object of a proposal into the room. not_found if the place is taken by now.
Status take_place(Work& work, const Proposal& proposal, std::size_t choice, Step& step);

/// What rests on other things, where a host wants it on WantedPose::on, else on the highest there,
/// or about as high as it says; nothing where none carries it.
std::optional<Object> resting(const Layout& layout, Object object, const WantedPose& wanted);

/// Puts an object exactly where a host wants it, locked. not_found if it cannot stand there.
Status put_at(Work& work, const PlannedObject& planned, const WantedPose& pose, Step& step);

/// Puts an object where the relations, the location and the facing of a host lead. not_found if
/// nowhere.
Status put_by(Work& work, const PlannedObject& planned, const PlaceAdvice& wish, Step& step);

/// A curtain or blind at its window, and the asset that is made to this measure.
struct Hanging {
  Object object;
  AssetInfo asset;
  std::string window;
};

/// Where a cover of a window (Kind::covers_window) hangs: at a window that has none, preferably the
/// one that its relations name; it needs no advice. not_found with the reason if nowhere.
Result<Hanging> find_hanging(Work& work, const PlannedObject& planned);

/// Curtains of the plan are as large as at their windows, for whoever chooses them.
void measure_covers(Workplace& place);

/// Hangs it up.
void hang_up(Work& work, const PlannedObject& planned, Hanging hanging);

/// All that is known of a room in this state: the scene in the plan's order with coordinates as a
/// file holds them, what found no place, the requirements' verdicts, figures.
Generation outcome(const Workplace& place, const BuildState& state);

}  // namespace roomgen
