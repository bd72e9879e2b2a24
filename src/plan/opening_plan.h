#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "opening_need.h"
#include "roomgen/scene/room.h"

namespace roomgen::plan {

// The one planner of openings: whoever gives a room doors, passages and windows says what needs a place, and
// in which parts of its walls.

/// How much an opening is in the way of others and of who enters: 10 for another in its place, 1 for the
/// clearance of a door that it crosses, 2 for a door before which nobody can stand, 1 for one that has the end
/// of its wall beside it and no wall there.
int conflicts(const Room& room, const Opening& opening);

/// What an opening is in the way of elsewhere, as in the next room.
using ConflictsBeyond = std::function<int(const Opening&)>;

/// The opening alone in a stretch, narrower if it must be, where it is least in the way.
Opening placed_alone(const Room& room, const OpeningNeed& need, const WallStretch& stretch,
                     const ConflictsBeyond& beyond = nullptr);

/// Where to put openings beside those that a room has.
struct OpeningPlaces {
  std::vector<WallStretch> stretches;  ///< of equals the first is taken
  ConflictsBeyond beyond;              ///< may be empty
};

/// Finds places for the needs, those that are told first. Each goes to a stretch that it is told or that suits
/// it: one with few openings, where it is in nobody's way, for a window across from the door, a long one. What
/// does not fit becomes narrower, goes elsewhere or is left out, which the notes say of what was asked for.
/// Several in one stretch are spread along it. Comes back with those that have a place, entrances first, else in
/// the order of the needs.
std::vector<Opening> place_openings(const Room& room, const OpeningPlaces& places,
                                    std::vector<OpeningNeed> needs, Random random,
                                    std::vector<std::string>& notes);

/// An id that no opening of the room has: "window-0", "door-0", also for a passage.
std::string free_opening_id(const Room& room, OpeningType type);
/// One for each opening that has none.
void name_openings(Room& room);

}  // namespace roomgen::plan
