#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/solve/solve.h"

namespace roomgen {

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
inline constexpr std::size_t most_sampled_things = 300;        ///< as many as a room is furnished with
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
