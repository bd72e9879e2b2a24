#pragma once

#include <optional>
#include <span>
#include <vector>

#include "layout.h"
#include "on_surface.h"
#include "roomgen/scene/problem.h"
#include "scene/judgement.h"
#include "suggestion.h"
#include "surroundings.h"

namespace roomgen {

/// Those that stand around the same target as an object.
struct Company {
  std::vector<Vec2> positions;  ///< centres of the others
  double share = 1.0;           ///< of the target's circumference for each, metres
};

/// What is proposed for one object and what the proposals draw on. Layout and task must outlive it.
struct ProposalContext {
  const Layout& layout;
  const PlacementTask& task;
  std::vector<ResolvedRelation> relations;
  /// How many will stand around the same target in the end, this one included.
  int around_count = 1;
  Suggestion suggestion = {};
  std::vector<Company> companies = {};  ///< one for each target that the object stands around
  /// Where the layout knows how kinds are arranged and no place is suggested: what its kind prefers.
  std::optional<Surroundings> surroundings = {};
  std::optional<Rest> rest = {};  ///< of what stands on another thing
  std::optional<Bounds2> whole = {};  ///< box_with_companions(), where there are any
};
ProposalContext make_context(const Layout& layout, const PlacementTask& task,
                             std::vector<ResolvedRelation> relations, int around_count);

/// The box around the object and what stands on the floor with it, in its frame.
Bounds2 box_with_companions(const PlacementTask& task);

/// How many of the objects stand around the same target as this one, itself included.
int count_around(const Object& object, std::span<const Object> others);

bool wants(const ProposalContext& context, RelationKind kind);

/// Poses with meaning: flush to each wall, in corners, against openings and neighbours, beside and
/// in front of targets at useful gaps, on seats around them, centred; and the suggested place
/// itself. Not yet tested for anything.
std::vector<Pose> propose_exact(const ProposalContext& context);

/// Are the two poses of an object no real alternatives, so near each other and turned alike?
bool are_alike(const Object& object, const Pose& a, const Pose& b);

struct Disc {
  Vec2 center = Vec2::Zero();
  double radius = 0.0;
};

/// Grid points over the room, or over a part of it, times orientations.
std::vector<Pose> propose_grid(const ProposalContext& context, double pitch,
                               const std::optional<Disc>& part = std::nullopt);

/// The orientations worth trying: fewer for things without a front.
std::vector<double> useful_yaws(const ProposalContext& context);

}  // namespace roomgen
