#pragma once

#include <limits>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// A level part of a mesh on which things can stand: a table top, one board of a shelf, the seat of
/// a chair, the mattress of a bed. Heights and places are those of the mesh. A mask of square cells
/// says what belongs to it.
struct SupportSurface {
  static constexpr double pitch = 0.02;  ///< of the cells, metres
  static constexpr double open = std::numeric_limits<double>::infinity();

  struct Cell {
    bool free = false;       ///< something can stand here
    float height = 0.0f;     ///< exact at the middle of the cell
    float clearance = 0.0f;  ///< up to the next face above, metres; `open` if there is none
  };

  double height = 0.0;     ///< the median
  double clearance = 0.0;  ///< the median
  double area = 0.0;       ///< m2
  Vec2 low = Vec2::Zero();  ///< outer corner of the first cell
  int columns = 0, rows = 0;
  std::vector<Cell> cells = {};  ///< row by row, along +x then +y

  Vec2 high() const { return low + pitch * Vec2(columns, rows); }
  Bounds2 box() const { return {low, high()}; }
  /// The cell over a point; null outside the mask.
  const Cell* at(const Vec2& point) const;
};

/// All surfaces of a mesh, the largest first. What counts: faces within 15 degrees of level whatever
/// their winding, reached from the side or from above (not the inside of a closed cabinet), with at
/// least 5 cm above them, 6 cm wide, and mostly flat (no balls; cushions are). Gently curved tops
/// count as one surface as long as they stay within 2.5 cm of their median height. The mesh may be
/// open and noisy.
std::vector<SupportSurface> support_surfaces(const Mesh& mesh);

}  // namespace roomgen
