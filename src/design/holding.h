#pragma once

#include "roomgen/scene/relation.h"
#include "sketch.h"

namespace roomgen::design {

/// A place that is being thought about.
struct Placed {
  const Object* self = nullptr;
  Pose pose;
  Footprint footprint;
  double bottom = 0.0;
};

/// Whether a relation would hold there, as docs/constraints.md defines it. `all` are the relations
/// of the object, since alignment depends on what else is asked. A relation to something that is
/// not there does not hold.
bool holds(const Sketch& sketch, const Placed& placed, const Relation& relation,
           const std::vector<Relation>& all);

/// Distance between the footprints, by kinds of targets.
double gap_to(const Placed& placed, const Target& target);

}  // namespace roomgen::design
