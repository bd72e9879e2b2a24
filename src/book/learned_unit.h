#pragma once

#include <array>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::book {

/// Copies of a group in rows and columns; metres from middle to middle in the frame of the first.
struct Grid {
  int rows = 1, columns = 1;
  double across = 0.0, along = 0.0;

  int number() const { return rows * columns; }
};

/// What stands together in a finished room: a group, or a single thing.
struct Unit {
  std::string id;
  std::vector<const Object*> things;  ///< the first is the anchor; of a grid those of one copy
  Grid grid;
  Vec2 at = Vec2::Zero();  ///< of the anchor, of a grid that of the first copy
  Bounds2 box;             ///< of what stands on the floor, all copies; else of what hangs

  const Object& anchor() const { return *things.front(); }
};

/// The units of a room, in the order of its things: the room's own groups, else what serves a thing
/// goes with it (seats at tables, what belongs beside a bed, rugs under, lamps over, what hangs
/// above a thing at its wall) and what stands on it. Equal groups in rows and columns are one unit.
std::vector<Unit> units_of(const Scene& scene, const KindTable& kinds);

/// Of groups that are alike those that fill rows and columns become one; the others stay as they
/// are.
std::vector<Unit> in_grids(std::vector<Unit> units);

/// The box of the things of a unit.
Bounds2 floor_box(const std::vector<const Object*>& things);

}  // namespace roomgen::book
