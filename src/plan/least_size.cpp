#include <cmath>

#include "room_makers.h"
#include "roomgen/scene/room.h"

namespace roomgen::plan {

namespace {

// Sums of steps drift.
double on_grid(double metres) { return std::round(metres / size_step) * size_step; }

double first_beyond(double side) { return on_grid(std::ceil(side / size_step - 1e-6) * size_step); }

}  // namespace

std::optional<Vec2> least_size(const Vec2& start, const std::function<bool(const Vec2&)>& works,
                               int most_steps) {
  const Vec2 first(first_beyond(start.x()), first_beyond(start.y()));
  const auto grown = [&](int step) {
    return Vec2(on_grid(first.x() + step * size_step), on_grid(first.y() + step * size_step));
  };
  int steps = 0;
  while (steps <= most_steps && grown(steps).maxCoeff() <= greatest_room_side &&
         !works(grown(steps)))
    ++steps;
  if (steps > most_steps || grown(steps).maxCoeff() > greatest_room_side) return std::nullopt;
  Vec2 least = grown(steps);
  for (const int side : {0, 1})
    while (least[side] > first[side] + 0.5 * size_step) {
      Vec2 shorter = least;
      shorter[side] = on_grid(least[side] - size_step);
      if (!works(shorter)) break;
      least = shorter;
    }
  return least;
}

}  // namespace roomgen::plan
