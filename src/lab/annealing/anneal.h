#pragma once

#include <array>
#include <functional>
#include <vector>

#include "moves.h"
#include "roomgen/base/cancel.h"

namespace roomgen::lab::annealing {

/// A thing of a state that is kept.
struct Placed {
  Slot slot = 0;
  int article = 0;
  Stance stance;
};

struct AnnealOptions {
  int steps = 0;
  bool cluster_moves = true;
  bool object_moves = true;
  bool always_usable = false;  ///< no state in which something cannot be used or reached is gone through
  double hottest = 3.0;   ///< temperature of the first step
  double widest = 1.5;    ///< metres by which things are shifted then
  CancelToken cancel;
  std::function<void(int step, const Worth& best, std::size_t things)> on_progress;
};

struct AnnealResult {
  std::vector<Placed> best;  ///< a valid room
  Worth worth;
  std::array<long long, move_kinds> tried{}, accepted{};
  struct Point {
    int step;
    Worth worth;
  };
  std::vector<Point> curve;  ///< each time the best got better, thinned out
  bool is_cut = false;
};

/// One chain from the world as it is.
AnnealResult anneal(World& world, Evaluator& evaluator, Moves& moves, Random& random, const AnnealOptions& options);

}  // namespace roomgen::lab::annealing
