#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/random.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/problem.h"
#include "roomgen/solve/fuse.h"
#include "roomgen/solve/layout.h"

namespace roomgen {

enum class GridUse {
  near_suggestions,  ///< always when a location is suggested, else as a last resort
  last_resort,       ///< when no pose with a meaning will do
  never,
};

struct PlaceOptions {
  FusionOptions fusion;
  double pitch = 0.10;  ///< of the grid, metres
  /// Candidates whose meshes and reachability are tested before giving up.
  int max_exact_tests = 300;
  /// Best candidates for which it is tried whether what depends on the object still finds its
  /// place.
  int lookahead = 12;
  /// When the points of the grid are looked at, beside the poses that mean something.
  GridUse grid = GridUse::near_suggestions;
  /// Added to degrees, uniform in [0, noise): makes repeated searches differ.
  double noise = 0.0;
  /// What is like one of these is left out: for the second best, and so on.
  std::vector<Pose> except = {};
  /// Ends the search with Error::Kind::cancelled.
  CancelToken cancel = {};

  Status validate() const;
};

/// Why a candidate stands where it does: degrees in [0, 1], for the trace.
struct PlacementTerms {
  int held = 0;  ///< constraints
  int lost = 0;
  double relations = 0.0;  ///< mean degree of the constraints
  double rest = 0.0;       ///< how well it stands on what carries it; 1 for what stands on the floor
  double walkway = 0.0;    ///< distance to the doors' clearances
  double spread = 0.0;     ///< no slots too narrow to walk through
  double evenness = 0.0;   ///< distance to others around the same target
  double closeness = 0.0;  ///< to the suggested location
  /// What its kind prefers (data/arrangements.json), a weighted sum; 0 where a place is suggested.
  double arrangement = 0.0;
  double rank_c = 0.0;
  double rank_l = 0.0;
  double fused = 0.0;
};

struct Placement {
  Object object;  ///< with its pose
  PlacementTerms terms;
  std::optional<PlacementTerms> runner_up;  ///< the best of the others, by rank alone
  int candidates = 0;                       ///< proposed
  int feasible = 0;                         ///< of them, passed the cheap tests
};

/// Finds the pose for one object: propose, score, rank, fuse, and take the best candidate that the
/// meshes and everybody's reachability allow. `later` are tasks still to come: those that depend on
/// this object are looked after. Does not change the layout in the end. Fails with a reason for
/// people when nothing is feasible, and when it is cancelled.
Result<Placement> place(Layout& layout, const PlacementTask& task,
                        std::span<const PlacementTask> later, const PlaceOptions& options,
                        Random& random);

/// The task with the soft constraint that leads the first way of its kind which can be named, as one of
/// its relations, and no longer `usual`: for searches that move many things.
PlacementTask with_leading_habit(const Layout& layout, PlacementTask task);

}  // namespace roomgen
