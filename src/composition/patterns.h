#pragma once

#include <vector>

#include "roomgen/geometry/polygon.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::composition {

/// A place of a part in a frame: its centre, and where its front looks.
struct Place {
  Vec2 position = Vec2::Zero();
  double yaw = 0.0;  ///< radians, counter-clockwise
};

/// A place within a frame, in the frame's own coordinates.
Place within(const Place& frame, const Place& place);

/// The outward normal of a side of a box in its own frame.
Vec2 outward(Side side);

/// Where one sits at a table: a point of its rim and the direction away from it.
struct SeatPlace {
  Vec2 rim = Vec2::Zero();
  Vec2 outward = Vec2::Zero();  ///< unit
};

/// The places of `count` seats: pairs face each other over the long sides, from the fifth on people
/// sit at the ends too where they are as wide as a seat; at a round table evenly.
std::vector<SeatPlace> seat_places(const Footprint& table, int count);

/// `count` places that share one side of a rectangular table.
std::vector<SeatPlace> seat_places_at_side(const Footprint& table, Side side, int count);

/// `count` middles along a line about 0: `pitch` apart, or sharing `length` evenly if that is 0.
std::vector<double> in_a_row(int count, double length, double pitch);

}  // namespace roomgen::composition
