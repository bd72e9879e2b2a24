#pragma once

#include <vector>

#include "resolved_relation.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A pose of the object to be judged.
struct Subject {
  Footprint footprint;
  double bottom = 0.0;
  double top = 0.0;
};

/// The meaning of every relation (docs/constraints.md): one definition for the solver, the reports
/// and the metrics.
Judgement judge(const ResolvedRelation& relation, const Subject& subject, const Room& room);

/// Judges every relation of every object of a scene, in order.
std::vector<RelationVerdict> judge_scene(const Scene& scene, const KindTable& categories);

}  // namespace roomgen
