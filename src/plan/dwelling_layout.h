#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/random.h"
#include "brief/dwelling_kinds.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::plan {

/// A room that is to be laid out.
struct LaidRoom {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string type;
  double area = 0.0;            ///< wanted, square metres
  std::size_t parent = none;    ///< from which it is entered; of the hub none
  Bounds2 box;                  ///< its inner faces
};

/// Packs rooms around one from which all are reached: a hall between two rows, or the living room
/// with rows along its sides. `parent` is set where a room is entered from one alone; those of the
/// others become the hub. If no room can be the hub, or it would have to serve too many, a hallway
/// is added at the end. Inner faces of neighbours are wall_thickness apart.
std::vector<LaidRoom> lay_out(std::vector<LaidRoom> rooms, const brief::DwellingKinds& kinds);

}  // namespace roomgen::plan
