#pragma once

#include <vector>

#include "inventory.h"

namespace roomgen::plan {

/// Where a block stands, and its focus: what its things look at or stand around, the screen of rows of seats, the
/// fireplace of a half circle of armchairs.

inline constexpr double before_audience = 1.2;  ///< metres for what is looked at, at least
inline constexpr double before_stage = 0.9;     ///< between it and who looks, where it stands on the floor
inline constexpr double margin = 0.45;          ///< metres to the walls

/// The part of the floor that is told, else all of it.
Bounds2 floor_of(const Draft& draft, const Room& room);

/// What a block looks at or stands around: what is told, what is told to be in front of it, else what such things
/// usually look at. Indices into `drafts`.
std::vector<std::size_t> foci_of(const Draft& block, const std::vector<Draft>& drafts, const KindTable& kinds);

/// How little a wall is one to look at, for choosing the least: those told, of the things or of their foci, are far below
/// 0; the front wall is below where other things are told to be at the front; one with windows or doors is above.
double cost_of_facing(const Room& room, std::size_t wall, const Draft& block, const std::vector<std::size_t>& foci,
                      const std::vector<Draft>& drafts);

/// Stands what is looked at before the middle of a wall that things around `center` look at, unless it was told where.
void put_at_wall(const std::vector<std::size_t>& foci, const Draft& block, std::size_t wall, const Vec2& center,
                 const Room& room, std::vector<Draft>& drafts);

}  // namespace roomgen::plan
