#pragma once

#include "sketch.h"

namespace roomgen::design {

/// True if a person (a disc of 0.5 m) who comes in by a door still gets to every thing that needs
/// reaching, `self` included, and from door to door, once `self` stands at `pose`. On a grid of
/// 0.1 m, so it errs by a few centimetres; without doors everything counts as reachable.
bool all_reachable(const Sketch& sketch, const Object& self, const Pose& pose, double bottom);

}  // namespace roomgen::design
