#pragma once

#include <vector>

#include "composition/patterns.h"

namespace roomgen {

using composition::SeatPlace;

/// composition::seat_places() for the seats that will come to a table: two to twelve at a round
/// one, to whose left the first sits, forty at most at a straight one.
std::vector<SeatPlace> seat_places(const Footprint& table, int count);

/// Is the footprint drawn up to the place?
bool is_at(const SeatPlace& place, const Footprint& footprint);

}  // namespace roomgen
