#pragma once

#include "assembly.h"
#include "geometry/convex_hull.h"

namespace roomgen::create::detail {

/// How a thing stands on its lowest points.
struct Standing {
  double low = 0.0;  ///< the lowest point
  double margin =
      0.0;  ///< from the centre of mass to the edge of what it stands on; negative outside
  Vec2 centre_of_mass = Vec2::Zero();
  Vec2 centre_of_ground = Vec2::Zero();
  std::vector<Vec2> hull;  ///< of what is within reach of the lowest point, counter-clockwise

  bool stable() const { return margin > 0.0; }
};

Standing standing(const std::vector<Part>& parts, double reach);

/// What is seen of a part from above.
std::vector<Vec2> plan_outline(const Part& part);

}  // namespace roomgen::create::detail
