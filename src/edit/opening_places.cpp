#include "opening_places.h"

#include <algorithm>
#include <cmath>

#include "plan/opening_plan.h"

namespace roomgen {

namespace {

constexpr double beside_wall = 0.12;       // metres from a wall that things hang at
constexpr double step_along = 0.1;          // metres along a wall
constexpr double behind_wall = 0.35;   // metres: further than any wall is thick
constexpr std::size_t most_places = 8;

// Behind a wall of a dwelling another room may lie, whose wall it is too.
const Room* room_behind(const Scene& scene, const Room& room, const Opening& opening) {
  const Vec2 behind = segment(room, opening).middle() - behind_wall * inward(room, opening);
  for (const auto& other : scene.rooms)
    if (other.id != room.id && contains(other.polygon, behind)) return &other;
  return nullptr;
}

// Parts of walls that keep clear of the corners and of the other openings.
std::vector<plan::WallStretch> free_walls(Room room, const Opening& opening) {
  std::erase_if(room.openings, [&](const Opening& other) { return other.id == opening.id; });
  auto free = plan::bare_walls(room);
  for (const auto& wall : plan::whole_walls(room)) {
    plan::cut(free, wall.wall, wall.from, wall.from + plan::between_openings);
    plan::cut(free, wall.wall, wall.to - plan::between_openings, wall.to);
  }
  return free;
}

// How many things are where the opening is to be, or in its way.
int things_before(const Scene& scene, const Room& room, const Opening& opening) {
  const auto areas = clearances(room, opening);
  const Segment line = segment(room, opening);
  return static_cast<int>(std::count_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    if (object.room != room.id || object.traits.flat || !object.on.empty() || object.mount == Mount::ceiling)
      return false;
    if (object.mount == Mount::wall)
      return gap(footprint(object), line) < beside_wall && bottom(object) < opening.head && top(object) > opening.sill;
    const bool is_low = opening.type == OpeningType::window && top(object) <= opening.sill + window_overlap;
    return !is_low && std::any_of(areas.begin(), areas.end(),
                                  [&](const Footprint& area) { return gap(area, footprint(object)) <= 0.0; });
  }));
}

}  // namespace

std::vector<Opening> opening_places(const Scene& scene, const Room& room, const Opening& wanted,
                                const std::optional<std::size_t>& wall, const std::optional<double>& at) {
  struct Place {
    Opening opening;
    int before = 0;
    double off = 0.0;
  };
  std::vector<Place> places;
  const double width = wanted.width();
  for (const auto& stretch : free_walls(room, wanted)) {
    if (wall && stretch.wall != *wall) continue;
    const double middle = 0.5 * room.polygon.edge(stretch.wall).length();
    for (double from = stretch.from; from <= stretch.to - width + 1e-9; from += step_along) {
      Opening opening = wanted;
      opening.wall = stretch.wall;
      opening.from = at ? *at - 0.5 * width : from;
      opening.to = opening.from + width;
      const bool is_free = opening.from >= stretch.from - 1e-9 && opening.to <= stretch.to + 1e-9;
      if (is_free && !room_behind(scene, room, opening))
        places.push_back({opening, things_before(scene, room, opening), std::abs(opening.from + 0.5 * width - middle)});
      if (at) break;
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.before != b.before ? a.before < b.before : a.off < b.off;
  });
  std::vector<Opening> openings;
  for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i) openings.push_back(places[i].opening);
  return openings;
}

}  // namespace roomgen
