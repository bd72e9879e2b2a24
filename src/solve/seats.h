#pragma once

#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// Where one sits at a table: a point of its rim and the direction away from it.
struct SeatPlace {
  Vec2 rim = Vec2::Zero();
  Vec2 outward = Vec2::Zero();  ///< unit
};

/// The places of `count` seats: pairs face each other over the long sides, from the fifth on people sit
/// at the ends too; at a round table evenly.
std::vector<SeatPlace> seat_places(const Footprint& table, int count);

/// `count` places that share one side (0 front, 1 back, 2 left, 3 right) of a rectangular table.
std::vector<SeatPlace> seat_places_at_side(const Footprint& table, int side, int count);

/// Is the footprint drawn up to the place?
bool is_at(const SeatPlace& place, const Footprint& footprint);

}  // namespace roomgen
