#include "fuse.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace roomgen {

namespace {

constexpr double cell = 0.20;
constexpr double nearer_by = 0.10;
// Sums that differ by less are equal: about a third of what one rank means at the top.
constexpr double sum_step = 4e-5;

// Distances to the location of the centres of all cells that hold a candidate, sorted.
std::vector<double> cell_distances(std::span<const Ranked> candidates, const Vec2& location) {
  std::vector<std::pair<std::int32_t, std::int32_t>> cells;
  for (const auto& candidate : candidates) {
    const Vec2 index = (candidate.position / cell).array().floor();
    cells.emplace_back(static_cast<std::int32_t>(index.x()), static_cast<std::int32_t>(index.y()));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<double> distances;
  for (const auto& [i, j] : cells)
    distances.push_back((cell * Vec2(i + 0.5, j + 0.5) - location).norm());
  std::sort(distances.begin(), distances.end());
  return distances;
}

void rank_by_cells(std::span<Ranked> candidates, const Vec2& location) {
  const auto distances = cell_distances(candidates, location);
  for (auto& candidate : candidates) {
    const double own = (candidate.position - location).norm();
    const auto nearer = std::lower_bound(distances.begin(), distances.end(), own - nearer_by);
    candidate.rank_l = 1.0 + static_cast<double>(nearer - distances.begin());
  }
}

template <typename Key>
void rank_ordinally(std::span<Ranked> candidates, double Ranked::*rank, Key key) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return key(candidates[a]) < key(candidates[b]);
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    candidates[order[i]].*rank = 1.0 + static_cast<double>(i);
}

}  // namespace

void fuse(std::span<Ranked> candidates, const std::optional<Vec2>& location,
          const FusionOptions& options) {
  if (candidates.empty()) return;
  if (options.ordinal_ranks) {
    rank_ordinally(candidates, &Ranked::rank_c,
                   [](const Ranked& r) { return static_cast<double>(r.lost); });
    if (location)
      rank_ordinally(candidates, &Ranked::rank_l,
                     [&](const Ranked& r) { return (r.position - *location).norm(); });
  } else {
    int least = candidates.front().lost;
    for (const auto& candidate : candidates) least = std::min(least, candidate.lost);
    for (auto& candidate : candidates)
      candidate.rank_c = 1.0 + options.lost_step * (candidate.lost - least);
    if (location) rank_by_cells(candidates, *location);
  }
  for (auto& candidate : candidates)
    candidate.fused = options.alpha / (candidate.rank_c + options.c) +
                      (location ? (1.0 - options.alpha) / (candidate.rank_l + options.c) : 0.0);
}

std::vector<std::size_t> order_of_choice(std::span<const Ranked> candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> step;
  for (const auto& candidate : candidates) step.push_back(std::round(candidate.fused / sum_step));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const Ranked& a = candidates[i];
    const Ranked& b = candidates[j];
    if (step[i] != step[j]) return step[i] > step[j];
    if (a.degree != b.degree) return a.degree > b.degree;
    return i < j;
  });
  return order;
}

}  // namespace roomgen
