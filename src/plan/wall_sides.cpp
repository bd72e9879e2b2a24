#include "wall_sides.h"

#include <algorithm>
#include <array>

namespace roomgen::plan {

namespace {

constexpr double side_cosine = 0.7;  // a wall looks to the left up to 45 degrees off

const Vec2& outward(std::size_t side) {
  static const std::array<Vec2, 4> directions = {Vec2(0, -1), Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0)};
  return directions[side % 4];
}

}  // namespace

std::vector<std::size_t> walls_towards(const Polygon& polygon, const Vec2& direction) {
  const auto length = [&](std::size_t wall) { return polygon.edge(wall).length(); };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (-polygon.inward(k).dot(direction) > side_cosine) found.push_back(k);
  std::stable_sort(found.begin(), found.end(),
                   [&](std::size_t a, std::size_t b) { return length(a) > length(b) + 1e-9; });
  return found;
}

std::vector<std::size_t> walls_on_side(const Polygon& polygon, int side) {
  return walls_towards(polygon, outward(static_cast<std::size_t>(side)));
}

std::size_t wall_on_side(const Polygon& polygon, std::size_t side) {
  std::size_t best = 0;
  double most = -1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double facing = -polygon.inward(k).dot(outward(side));
    // A wall that hardly looks there is none of that side, however long.
    const double score = (facing > side_cosine ? 1e3 : 0.0) + facing * polygon.edge(k).length();
    if (score > most + 1e-9) best = k, most = score;
  }
  return best;
}

}  // namespace roomgen::plan
