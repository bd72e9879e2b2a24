#pragma once

#include <cstddef>
#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

// How many places are tried for one thing, in rooms with more walls or more floor than people live in (docs/limits.md):
// without a limit the work grows with the floor times the directions of walls, and each place is held against all walls.

/// Turns of a thing: a room of more directions is tried in so many, evenly chosen.
inline constexpr std::size_t most_turns = 32;
/// Points of a grid times turns, and that times walls.
inline constexpr double most_on_grid = 400'000.0;
inline constexpr double most_against_walls = 16'000'000.0;
/// The same where it is only looked what is mostly in the way.
inline constexpr double most_looked_at = 50'000.0;
/// Steps along all walls together.
inline constexpr double most_along_walls = 20'000.0;

/// Walls times turns of a room in which improvement takes all its rounds.
inline constexpr std::size_t most_directions = 512;

/// At most `most_turns` of them, in their order.
std::vector<double> thinned(std::vector<double> turns);

/// The pitch that was asked for, or the finest with which a grid over the room stays within the limits.
double pitch_within_limit(double pitch, const Polygon& polygon, std::size_t turns, double most = most_on_grid);

/// The same of steps along all walls.
double step_within_limit(double step, const Polygon& polygon);

/// Rounds of improvement: the dearer each is, the fewer.
int rounds_within_limit(int rounds, std::size_t walls, std::size_t turns);

}  // namespace roomgen
