#pragma once

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

/// What is about a rug, in its frame.
struct AboutRug {
  std::vector<Bounds2> things;  ///< it may end just beyond them
  std::vector<Bounds2> parts;   ///< of the things: it may end just before them
  std::vector<Vec2> corners;    ///< of the room: it may reach as far
};

/// Ways to cut a rug of this size so that it ends where what is about it suggests, the smallest change
/// first. The first is the rug as it lay. A round one stays in shape.
std::vector<RugCut> rug_cuts(const Vec2& size, bool round, const RugRange& range, const AboutRug& about);

}  // namespace roomgen
