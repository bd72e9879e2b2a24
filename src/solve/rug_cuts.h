#pragma once

#include <span>
#include <vector>

#include "roomgen/geometry/polygon.h"

namespace roomgen {

/// A rectangle of floor that a rug could cover, in the frame of the rug as it lay.
struct RugCut {
  Bounds2 area;
  double change = 0.0;  ///< metres: how much wider, deeper or smaller, and how far it lies from where it did
};

/// How far the sides of a rug may change, in parts of what they were.
struct RugRange {
  double least = 1.0, most = 1.0;
};

/// The ways to cut a rug of this size so that its edges lie just beyond or just before the parts of things
/// and inside the corners of the room (all in the rug's frame), the smallest change first. The first is the
/// rug as it lay. A round one stays in shape.
std::vector<RugCut> rug_cuts(const Vec2& size, bool round, const RugRange& range,
                             std::span<const Bounds2> parts, std::span<const Vec2> corners);

}  // namespace roomgen
