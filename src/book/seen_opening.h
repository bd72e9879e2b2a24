#pragma once

#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/scene/room.h"

namespace roomgen::book {

/// A door or window of a room as designs have it: by the sides of the room's box.
struct SeenOpening {
  int side = 0;         ///< south, east, north, west
  double middle = 0.0;  ///< metres from the west or south end of that side
  double width = 1.0;
  double sill = 0.0;
  bool is_window = false;
};
std::vector<SeenOpening> openings_seen(const Room& room);

/// Whether an opening of a design is a window rather than a door or passage: by its kind.
bool is_window(const Json& opening);

}  // namespace roomgen::book
