#pragma once

#include <functional>
#include <vector>

#include "surface.h"

namespace roomgen::shape {

/// A line of the grid on a face of a cube: where it is, -1 to 1, and the half that it counts to.
struct Tick {
  double at = 0.0;
  double side = 0.0;
};

/// Wraps the six gridded faces of the cube [-1, 1]^3 around a body. `place` maps a point of the
/// cube (and the halves it counts to, an axis each) to a position with its normal; it must depend
/// on nothing else, so that faces agree along their edges. Ticks are ascending and symmetric.
void add_cube_skin(SurfaceBuilder& surface, const std::vector<Tick>& ticks,
                   const std::function<Corner(const Vec3& at, const Vec3& side)>& place);

}  // namespace roomgen::shape
