#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomgen/generate/generate.h"
#include "roomgen/solve/solve.h"
#include "warm_library.h"

namespace roomgen::bench {

/// What came of some rooms.
struct Outcome {
  int rooms = 0;
  int constraints = 0, held = 0;
  int wanted = 0, placed = 0;
  int requirements = 0, met = 0;  ///< of prompts
  double seconds = 0.0;           ///< processor time of this thread and those it waits for
  double slowest = 0.0;           ///< of one room
  std::vector<Scene> scenes;
};

/// The rooms on which ways to solve are compared: problems (tests/data/solver-scenes and tests/data/rooms) and
/// plans by rules of every third prompt of bench/golden and of the room of 44 things, whose meshes are loaded
/// beforehand. What is planned does not depend on the options that are compared.
class RoomCases {
 public:
  /// Of the problems and plans each `step`-th.
  explicit RoomCases(std::size_t step = 1);
  ~RoomCases();

  Outcome solve_all(const SolveOptions& options) const;
  Outcome furnish_all(const BuildOptions& options) const;

 private:
  std::vector<Problem> problems_;
  std::vector<Plan> plans_;
  std::unique_ptr<AssetLibrary> library_;
  std::unique_ptr<WarmLibrary> warm_;
};

/// Both as one.
Outcome sum(Outcome a, const Outcome& b);

}  // namespace roomgen::bench
