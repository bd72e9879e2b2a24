#pragma once

#include <cstdint>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/problem.h"
#include "roomgen/scene/scene.h"
#include "roomgen/solve/placement.h"

namespace roomgen {

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
