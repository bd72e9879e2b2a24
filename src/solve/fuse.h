#pragma once

#include <optional>
#include <span>
#include <vector>

#include "roomgen/geometry/vec.h"
#include "roomgen/solve/solve.h"

namespace roomgen {

/// One candidate as the fusion sees it.
struct Ranked {
  Vec2 position = Vec2::Zero();
  int lost = 0;         ///< constraints that do not hold
  double degree = 0.0;  ///< how well it does otherwise; decides between nearly equal sums
  double rank_c = 1.0;
  double rank_l = 1.0;
  double fused = 0.0;
};

/// Fills the ranks and the fused score of feasible candidates.
///   rank_c = 1 + lost_step * (lost - least lost)
///   rank_l = 1 + number of distinct 0.20 m cells that hold a candidate and lie nearer to
///   `location` by
///            more than 0.10 m; without a location the term is 0
///   fused  = alpha / (rank_c + c) + (1 - alpha) / (rank_l + c)
void fuse(std::span<Ranked> candidates, const std::optional<Vec2>& location,
          const FusionOptions& options);

/// Indices in falling order of choice: fused score, then degree, then position and index.
std::vector<std::size_t> order_of_choice(std::span<const Ranked> candidates);

}  // namespace roomgen
