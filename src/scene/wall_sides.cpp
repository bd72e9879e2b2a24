#include "wall_sides.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace roomgen {

namespace {

constexpr double side_cosine = 0.7;  // a wall looks to the left up to 45 degrees off

const Vec2& outward(std::size_t side) {
  static const std::array<Vec2, 4> directions = {Vec2(0, -1), Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0)};
  return directions[side % 4];
}

// As walls_on_side() counts them.
constexpr std::array<std::string_view, 4> compass = {"south", "east", "north", "west"};
constexpr std::string_view numbered = "wall-";

std::optional<std::size_t> number_of(std::string_view name) {
  if (!name.starts_with(numbered)) return std::nullopt;
  const char* end = name.data() + name.size();
  std::size_t wall = 0;
  const auto [last, error] = std::from_chars(name.data() + numbered.size(), end, wall);
  return error == std::errc() && last == end ? std::optional(wall) : std::nullopt;
}

}  // namespace

std::string_view compass_name(int side) {
  return compass[static_cast<std::size_t>(side)];
}

std::optional<int> compass_side(std::string_view name) {
  const auto side = std::find(compass.begin(), compass.end(), name) - compass.begin();
  return side < static_cast<std::ptrdiff_t>(compass.size()) ? std::optional(static_cast<int>(side))
                                                            : std::nullopt;
}

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

std::vector<std::size_t> walls_named(const Room& room, std::string_view name) {
  if (const auto wall = number_of(name))
    return *wall < room.polygon.size() ? std::vector{*wall} : std::vector<std::size_t>();
  if (name == accent_name) return {accent_wall(room)};
  const auto side = compass_side(name);
  if (!side) return {};
  auto walls = walls_on_side(room.polygon, *side);
  if (walls.empty()) walls = {wall_on_side(room.polygon, static_cast<std::size_t>(*side))};
  return walls;
}

bool is_wall_name(std::string_view name) {
  return name == accent_name || number_of(name) || compass_side(name);
}

}  // namespace roomgen
