#include "usual_openings.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace roomgen::design {

namespace {

// From the corner of a bay to its glass, and the least that is worth glazing.
constexpr double glazing_margin = 0.1, least_glazing = 0.3;
constexpr double bay_sill = 0.5;
constexpr double wide_window = 1.5;  // against a usual one

bool can_be_entered(const Room& room, const Opening& door) {
  return contains(room.polygon, door_clearance(room, door));
}

// At the end that is wanted if that is a corner of the room and people can pass there, else at the
// other, else in the middle.
Opening door_at_end(const Room& room, const RoomKind& kind, std::size_t wall, bool at_from) {
  const WallStretch whole = whole_wall(room, wall);
  for (const bool from : {at_from, !at_from}) {
    const std::size_t corner = from ? wall : (wall + 1) % room.polygon.size();
    const Opening door = usual_door(kind, whole, room.height, from);
    if (room.polygon.is_convex_corner(corner) && can_be_entered(room, door)) return door;
  }
  Opening door = usual_door(kind, whole, room.height, at_from);
  move_to(door, middle_for(whole, door.width()));
  return door;
}

// Balconies are entered through the middle of the wall of the dwelling.
Opening door_in_middle(const Room& room, const RoomKind& kind, std::size_t wall, Random& random) {
  Opening door = usual_door(kind, whole_wall(room, wall), room.height, true);
  const double spare = room.polygon.edge(wall).length() - door.width();
  move_to(door, std::max(0.0, std::min(spare, spare * random.uniform(0.3, 0.7))));
  return door;
}

Opening window_in(const Room& room, const RoomKind& kind, std::size_t wall, bool wide,
                  Random& random) {
  const double length = room.polygon.edge(wall).length();
  const double width =
      std::min(usual_window_width(kind, wide, random), length - 2.0 * window_margin);
  const double middle = length * random.uniform(0.42, 0.58);
  const double from =
      std::clamp(middle - 0.5 * width, window_margin, length - window_margin - width);
  return usual_window(kind, wall, from, width, room.height);
}

// The whole of a bay's wall.
Opening glazing_in(const Room& room, const RoomKind& kind, std::size_t wall) {
  const double width = room.polygon.edge(wall).length() - 2.0 * glazing_margin;
  Opening window = usual_window(kind, wall, glazing_margin, width, room.height);
  window.sill = std::min(window.sill, bay_sill);
  return window;
}

// Walls for windows: opposite the door first, then beside it, the door's own last.
std::vector<std::size_t> window_walls(const Polygon& polygon, std::size_t door_wall,
                                      Random& random) {
  const std::size_t n = polygon.size();
  const std::size_t step = random.chance(0.5) ? 1 : n - 1;
  std::vector<std::size_t> walls;
  for (std::size_t k = 1; k < n; ++k) walls.push_back((door_wall + k * step) % n);
  const auto opposite = [&](std::size_t wall) {
    return std::lround(-100.0 * polygon.inward(wall).dot(polygon.inward(door_wall)));
  };
  std::stable_sort(walls.begin(), walls.end(),
                   [&](std::size_t a, std::size_t b) { return opposite(a) > opposite(b); });
  return walls;
}

bool is_glazed(std::span<const std::size_t> glazed, std::size_t wall) {
  return std::find(glazed.begin(), glazed.end(), wall) != glazed.end();
}

// Walls that take a door and before which there is room for it; the longest ones if none does.
std::vector<std::size_t> door_walls(const Room& room, const RoomKind& kind,
                                    std::span<const std::size_t> glazed) {
  const Polygon& polygon = room.polygon;
  double longest = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    longest = std::max(longest, polygon.edge(k).length());
  std::vector<std::size_t> walls, long_ones;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double length = polygon.edge(k).length();
    if (length > longest - 1e-6) long_ones.push_back(k);
    if (!is_glazed(glazed, k) && length >= kind.door + door_margin &&
        can_be_entered(room, door_at_end(room, kind, k, true)))
      walls.push_back(k);
  }
  return walls.empty() || kind.door_on_long_side ? long_ones : walls;
}

Opening make_door(const Room& room, const RoomKind& kind, std::span<const std::size_t> glazed,
                  Random& random) {
  const auto walls = door_walls(room, kind, glazed);
  if (kind.door_on_long_side)
    return door_in_middle(room, kind, walls[random.chance(0.5) ? walls.size() - 1 : 0], random);
  const std::size_t wall = random.pick(walls);
  return door_at_end(room, kind, wall, random.chance(0.5));
}

// The longest wall without openings; the number of walls if there is none.
std::size_t longest_bare_wall(const Room& room) {
  std::size_t longest = room.polygon.size();
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const bool free = std::none_of(room.openings.begin(), room.openings.end(),
                                   [&](const Opening& opening) { return opening.wall == k; });
    if (free && (longest == room.polygon.size() ||
                 room.polygon.edge(k).length() > room.polygon.edge(longest).length()))
      longest = k;
  }
  return longest;
}

bool takes_window(const Room& room, std::size_t wall) {
  return room.polygon.edge(wall).length() >= 2.0 * window_margin + least_window;
}

}  // namespace

Opening usual_door(const RoomKind& kind, const WallStretch& stretch, double ceiling, bool at_from) {
  const double width = door_width(kind.door, stretch);
  const StretchEnds ends = ends_for(stretch, width);
  Opening door = opening_at(OpeningType::door, stretch.wall, at_from ? ends.low : ends.high, width,
                            std::min(default_door_head, ceiling));
  door.id = "door-0";
  // The leaf opens against the wall beside it.
  door.hinge_at_from = at_from;
  door.swing = kind.swing;
  return door;
}

Opening usual_window(const RoomKind& kind, std::size_t wall, double from, double width,
                     double ceiling) {
  Opening window = opening_at(OpeningType::window, wall, from, width,
                              std::min(kind.windows.head, ceiling - under_ceiling));
  window.sill = std::min(kind.windows.sill, window.head - least_height);
  return window;
}

double usual_window_width(const RoomKind& kind, bool wide, Random& random) {
  const double width = random.uniform(kind.windows.width.low, kind.windows.width.high);
  return wide ? wide_window * width : width;
}

void add_usual_openings(Room& room, const RoomKind& kind, std::span<const std::size_t> glazed,
                        int windows, bool wide_windows, Random& random) {
  room.openings.push_back(make_door(room, kind, glazed, random));
  const auto add = [&](Opening window) {
    window.id = "window-" + std::to_string(room.openings.size() - 1);
    room.openings.push_back(std::move(window));
  };
  const std::size_t door_wall = room.openings[0].wall;
  for (const std::size_t wall : glazed)
    if (wall != door_wall && room.polygon.edge(wall).length() > 2 * glazing_margin + least_glazing)
      add(glazing_in(room, kind, wall));
  // A bay is one of the windows.
  int left = windows - (room.openings.size() > 1 ? 1 : 0);
  for (const std::size_t wall : window_walls(room.polygon, door_wall, random)) {
    if (left <= 0) break;
    if (is_glazed(glazed, wall)) continue;
    --left;
    if (takes_window(room, wall)) add(window_in(room, kind, wall, wide_windows, random));
  }
}

bool ensure_door(Room& room, const RoomKind& kind) {
  if (std::any_of(room.openings.begin(), room.openings.end(),
                  [](const Opening& opening) { return opening.is_entrance(); }))
    return false;
  const std::size_t longest = longest_bare_wall(room);
  if (longest == room.polygon.size()) return false;
  Opening door = door_at_end(room, kind, longest, true);
  for (int n = 0; find_opening(room, door.id); ++n) door.id = "door-" + std::to_string(n + 1);
  room.openings.push_back(door);
  return true;
}

void add_windows(Room& room, const RoomKind& kind, int count, bool wide, Random random) {
  for (int i = 0; i < count; ++i) {
    const std::size_t wall = longest_bare_wall(room);
    if (wall == room.polygon.size() || !takes_window(room, wall)) return;
    Opening window = window_in(room, kind, wall, wide, random);
    window.id = "window-" + std::to_string(i);
    room.openings.push_back(window);
  }
}

}  // namespace roomgen::design
