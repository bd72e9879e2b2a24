#pragma once

#include <span>
#include <vector>

#include "roomgen/evaluate/relations.h"
#include "roomgen/scene/problem.h"
#include "roomgen/solve/layout.h"

namespace roomgen {

/// What is proposed for one object and what the proposals draw on.
struct ProposalContext {
  const Layout& layout;
  const PlacementTask& task;
  const std::vector<ResolvedRelation>& relations;
  /// How many objects stand around the same target, this one included: they share its sides.
  int around_count = 1;
};

/// How many of the objects stand around the same target as this one, itself included.
int count_around(const Object& object, std::span<const Object> others);

bool wants(const ProposalContext& context, RelationKind kind);

/// Poses with meaning: flush to each wall, in corners, against openings and neighbours, beside and
/// in front of targets at useful gaps, on seats around them, centred; and the suggested place
/// itself. Not yet tested for anything.
std::vector<Pose> propose_exact(const ProposalContext& context);

/// Grid points over the room times orientations.
std::vector<Pose> propose_grid(const ProposalContext& context, double pitch);

/// The orientations worth trying: fewer for things without a front.
std::vector<double> useful_yaws(const ProposalContext& context);

}  // namespace roomgen
