#pragma once

#include "roomgen/scene/judgement.h"
#include "sketch.h"

namespace roomgen::design {

/// A place that is being thought about.
struct Placed {
  const Object* self = nullptr;
  Pose pose;
  Footprint footprint;
  double bottom = 0.0;
};

/// Relations of an object with their targets, ready to be judged at many places. They belong
/// together: alignment depends on what else is asked.
std::vector<ResolvedRelation> resolve_all(const Sketch& sketch, Object self,
                                          const std::vector<Relation>& relations);

/// Whether a relation would hold there (docs/constraints.md). A relation to something that is not
/// there does not hold.
bool holds(const Sketch& sketch, const Placed& placed, const ResolvedRelation& relation);

/// Distance between the footprints, by kinds of targets.
double gap_to(const Placed& placed, const Target& target);

}  // namespace roomgen::design
