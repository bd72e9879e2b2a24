#pragma once

#include <string>
#include <vector>

#include "roomgen/geometry/footprint.h"

namespace roomgen {

enum class Side { front, back, left, right };

/// Floor beside an object that a person needs to use it: the whole length of one side of its box,
/// `depth` metres deep.
struct UseZone {
  Side side = Side::front;
  double depth = 0.6;
  std::vector<std::string> partners;  ///< categories that may stand in it (a chair at its desk)
};

/// Of a table's edge, for each who sits there; metres (NKBA Kitchen & Bathroom Planning Guidelines).
inline constexpr double seat_width = 0.61;

/// The floor that a zone of a placed object covers.
Footprint zone_footprint(const Footprint& object, const UseZone& zone);

}  // namespace roomgen
