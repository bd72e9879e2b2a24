#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// What a place can be good for (docs/arrangements.md says how each is measured).
enum class Preference {
  door,           ///< far from the door
  door_line,      ///< in the line of sight through the door
  door_ahead,     ///< looking towards the door
  window,         ///< near a window
  window_behind,  ///< with the back to a window
  window_ahead,   ///< looking at a window
  window_wall,    ///< at a wall with a window
  wall_middle,    ///< in the middle of its wall
  side_wall,      ///< with one side close to a second wall
  corner,         ///< close to a corner of the room
  wall_near,      ///< close to any wall
  run,            ///< with free wall beside it, for more units in a row
  bare_wall,      ///< where nothing stands or hangs before the wall
  center,         ///< in the middle of the room
  aside,          ///< out of the way: far from the line between door and the middle
  apart,          ///< far from its like
  view,           ///< with free floor before it
  square,         ///< parallel to the walls
  angle,          ///< turned towards its target
  long_axis,      ///< its long side along the room's
  flank,          ///< with free floor on both sides
  screen_free,    ///< not between a seat and what it looks at
  rows,           ///< in line with its like
};

struct WeightedPreference {
  Preference what;
  double weight;  ///< negative: avoids
};

/// How things of one kind are placed: soft constraints of the solver, which give way to what is asked.
struct Arrangement {
  int stage = 4;  ///< what has a lower one is placed earlier
  /// Constraints in order of importance; a target is a category, "exactly table" for
  /// that category without its descendants, "door" or "window". The first way
  /// whose targets exist is taken.
  std::vector<std::vector<Relation>> ways;
  /// Ways for what the prompt asks for, or what was refused elsewhere, when no other will do; what
  /// was merely added is rather left out.
  std::vector<std::vector<Relation>> otherwise;
  std::vector<WeightedPreference> preferences;
  std::array<double, 4> reserve{};  ///< floor to leave open, by Side
  bool seats = false;               ///< shares the sides of its table with its like
  int rows_from = 0;                ///< so many of them stand in rows where nothing else is said; 0: never
  /// For a rug, by category of its target: how far before the target's front side its centre lies,
  /// in metres; others lie under the centre of the target.
  std::map<std::string, double, std::less<>> over;
};

/// data/arrangements.json (docs/arrangements.md).
struct Arrangements {
  std::map<std::string, Arrangement, std::less<>> kinds;
  /// Of groups as a whole, by their composition (its "wants").
  std::map<std::string, Arrangement, std::less<>> compositions;

  /// That of the category, of its nearest ancestor, or of the things of its mount.
  const Arrangement& get(const KindTable& table, std::string_view category, Mount mount) const;
};

Result<Arrangements> parse_arrangements(std::string_view text, const std::string& source);
/// The knowledge compiled into the library.
const Result<Arrangements>& built_in_arrangements();

}  // namespace roomgen
