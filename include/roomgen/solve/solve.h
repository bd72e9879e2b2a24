#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/kind_table.h"
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

/// What counts how much between candidates that lose equally many constraints. Degrees are in [0, 1] unless
/// said otherwise. docs/benchmarks.md ("The weights") says what half and twice of them changes, as far as it was
/// measured.
struct Weights {
  // Of a thing that is not at a usual place of its kind (data/arrangements.json).
  double relations = 1.0;
  double rest = 0.8;
  double walkway = 0.15;
  double spread = 0.15;
  double evenness = 0.3;
  double closeness = 0.5;
  double facing = 0.5;  ///< of the suggested yaw against the suggested centre

  /// Of a metre off a designer's word: two centimetres outweigh any other degree of the poses about it.
  double off = 100.0;
  /// Ten degrees off what was said are as bad as 0.1 m.
  double metres_a_radian = 0.573;

  // The soft constraints of a way: the first counts most, so that one more outweighs preferences.
  double first_habit = 6.0;
  double habit_step = 0.5;
  double most_steps = 6.0;
  double burden = 4.0;  ///< a partner that has all the company it wants already
  /// Preferences are dear to tell and never make up for more than this.
  double most_preference = 8.0;

  // Besides the preferences of its kind, which bring weights of their own.
  double reserve_open = 2.4;   ///< the floor that its use will want is open
  double reserve_taken = 1.2;  ///< of another's, for each
  double crowded = 1.5;        ///< at the same side of the target as its like
  double squareness = 0.5;     ///< parallel to the walls, of what its kind says nothing else
  double pair_gap = 0.6;       ///< as far from a partner as the pair prefers
  double asked_pair_gap = 8.0;
  double asked_middle = 4.0;     ///< what is to be in the middle is so by degrees
  double askew = 8.0;            ///< a radian between the front and what it is to face
  double beyond_opposite = 1.0;  ///< a metre farther than what is opposite
  double seat_place = 2.0;       ///< at one of the places that a table has for so many
  double over_place = 2.0;       ///< a rug lies as its group wants it
  double plan_location = 3.0;    ///< where the plan wants it
};

enum class GridUse {
  near_suggestions,  ///< always when a location is suggested, else as a last resort
  last_resort,       ///< when no pose with a meaning will do
  never,
  only,         ///< no pose with a meaning (RoomGen)
};

struct PlaceOptions {
  FusionOptions fusion;
  Weights weights;
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
  /// Other poses are left out, if it is set; asked of those that pass the cheap tests.
  std::function<bool(const Pose&)> accepts = {};
  /// Also where it, or what stands already, could be used or reached by nobody; from door to door one
  /// walks all the same.
  bool even_useless = false;
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
  /// Is a layout that holds every constraint searched for first?
  bool layout_search = true;
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

/// What makes two layouts of the same things distinct: some thing that stands on the floor is so far from where it is
/// in the other, or turned so far. Things that could change places unseen count as one another, and what has no front
/// looks the same from several sides.
struct Apart {
  double metres = 0.3;
  double radians = pi / 4;
};

struct SampleOptions {
  std::size_t count = 100;  ///< of layouts that are wanted
  SolveOptions solve;       ///< of the solution that is varied; its seed is that of the samples too
  Apart apart;
  std::size_t chains = 8;   ///< that are started apart from each other: others, other layouts
  unsigned threads = 0;     ///< 0: as many as the machine has. The same layouts for any number
};

/// One layout: poses in the order of the objects of Samples::scene.
struct SampledLayout {
  std::vector<Pose> poses;
  int held = 0;        ///< constraints
  double score = 0.0;  ///< the mean degree of the constraints, in [0, 1]
};

/// Distinct layouts of one room.
struct Samples {
  Scene scene;  ///< what is varied; what it leaves out, the layouts leave out
  std::vector<SampledLayout> layouts;
  std::uint64_t seed = 0;
  int constraints = 0;
  std::size_t drawn = 0;  ///< layouts that were compared; those like an earlier one were dropped
};

/// Of each thing up to 40,000 places are known, and each layout is kept: what is drawn at once is bounded.
inline constexpr std::size_t most_sampled_things = 300;  ///< as many as a room is furnished with
inline constexpr std::size_t most_sampled_poses = 10'000'000;  ///< layouts wanted times things

/// Draws layouts of a problem, every two of them distinct. Each is valid (docs/constraints.md), places what the
/// solution of solve() places, and holds all constraints that it holds. Fewer than were asked for when no others are
/// found in bounded time: counted in steps, so that equal input gives equal layouts on any machine, and more begin
/// with the fewer. They are spread widely, but not evenly: nothing is said of how likely each is. Error::Kind::limit for
/// more things or layouts than the above.
Result<Samples> sample(const Problem& problem, const ModelTable& models, const KindTable& kinds,
                       const SampleOptions& options = {});
/// The same for a furnished room of one's own instead of a solution. What is locked stays, and curtains stay at their
/// windows.
Result<Samples> sample(const Scene& scene, const ModelTable& models, const KindTable& kinds,
                       const SampleOptions& options = {});

/// One line of a file of layouts (docs/layout.schema.json).
Json to_json(const Samples& samples, std::size_t index);
/// What such a line means, in the room and with the things that were varied, wherever they stand there.
Result<Scene> scene_of_layout(const Json& json, const Scene& things, const std::string& source);
/// The things of a problem in its room, at no places of their own: what the layouts of a problem are of.
Scene things_of(const Problem& problem);

/// The scene with its things as the layout has them.
Scene with_layout(Scene scene, const SampledLayout& layout);

}  // namespace roomgen
