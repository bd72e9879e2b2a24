#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/problem.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// Where a thing might stand.
struct Pose {
  Vec2 position = Vec2::Zero();  ///< centre
  double bottom = 0.0;
  double yaw = 0.0;
};

/// How two rankings become one (papers: RoomGen, equation 1; reciprocal rank fusion after Cormack
/// et al. 2009).
struct FusionOptions {
  double alpha = 0.5;      ///< weight of the constraints against the suggested location, in [0, 1]
  double c = 60.0;         ///< the fusion's constant
  double lost_step = 120;  ///< ranks that one lost constraint costs
  /// The literal form: ordinal ranks over all candidates, first come first in ties. Its choice
  /// depends on the pitch of the grid.
  bool ordinal_ranks = false;
};

enum class GridUse {
  near_suggestions,  ///< always when a location is suggested, else as a last resort
  last_resort,       ///< when no pose with a meaning will do
  never,
  only,         ///< no pose with a meaning (RoomGen)
};

struct PlaceOptions {
  FusionOptions fusion;
  double pitch = 0.10;  ///< of the grid, metres
  double least_near = 0.0;  ///< metres, the gap from which `near` holds here
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

/// What an improvement may move besides what stands where nobody said.
enum class Improvement {
  off,      ///< nothing is improved
  minimal,  ///< what somebody put there (PlacementTask::binding) only for what was asked for, by the least way
  free,     ///< everything
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
  /// Metres off a suggestion that binds, 10 degrees counting as 0.1 m; no degree.
  double off = 0.0;
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

struct SolveOptions {
  PlaceOptions place;
  /// Rounds of improvement when not everything could be had at once; counted, not timed, so that
  /// equal input gives equal output on any machine.
  int rounds = 300;
  std::uint64_t seed = 0;
  CancelToken cancel;
};

struct Solution {
  Scene scene;  ///< unplaced objects with their reasons; `incomplete` when cancelled
  int constraints = 0;
  int held = 0;
  int rounds = 0;
};

/// Places all objects of a problem: all at once by a search that holds every constraint, if it
/// finds such a layout in bounded time; else one after the other with an eye on those to come, then
/// repairs. Never fails for want of space; fails when the problem itself is unsound.
Result<Solution> solve(const Problem& problem, const ModelTable& models,
                       const KindTable& categories, const SolveOptions& options = {});

}  // namespace roomgen
