#include "trials.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

std::vector<double> thinned(std::vector<double> turns) {
  if (turns.size() <= most_turns) return turns;
  for (std::size_t i = 0; i < most_turns; ++i) turns[i] = turns[i * turns.size() / most_turns];
  turns.resize(most_turns);
  return turns;
}

double pitch_within_limit(double pitch, const Polygon& polygon, std::size_t turns, double most) {
  most = std::min(most, most_against_walls / static_cast<double>(std::max<std::size_t>(polygon.size(), 1)));
  return std::max(pitch, std::sqrt(bounds(polygon).size().prod() * static_cast<double>(turns) / most));
}

double step_within_limit(double step, const Polygon& polygon) {
  double around = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) around += polygon.edge(k).length();
  return std::max(step, around / most_along_walls);
}

int rounds_within_limit(int rounds, std::size_t walls, std::size_t turns) {
  const std::size_t directions = walls * turns;
  if (directions <= most_directions) return rounds;
  const double share = static_cast<double>(most_directions) / static_cast<double>(directions);
  return std::min(rounds, std::max(2, static_cast<int>(share * rounds)));
}

}  // namespace roomgen
