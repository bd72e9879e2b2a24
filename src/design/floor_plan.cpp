#include "floor_plan.h"

#include <algorithm>
#include <cmath>

namespace roomgen::design {

namespace {

// From the corner to the frame: room for the frame and for the hand on the handle.
constexpr double door_offset = 0.12;
constexpr double window_margin = 0.35;
constexpr double under_ceiling = 0.1;

double to_grid(double metres) {
  return std::round(metres * 10.0) / 10.0;
}

// Width and depth of a given area in the proportions of the kind.
Vec2 of_area(double area, const RoomKind& kind, Random& random) {
  const double usual =
      0.5 * (kind.width.low + kind.width.high) / (0.5 * (kind.depth.low + kind.depth.high));
  const double ratio = std::clamp(usual * random.uniform(0.9, 1.15), 1.0, 2.5);
  const double depth = std::sqrt(area / ratio);
  return {area / depth, depth};
}

Opening door_in(const Room& room, const RoomKind& kind, std::size_t wall, bool at_from) {
  const double length = room.polygon.edge(wall).length();
  const double width = std::min(kind.door, std::max(0.3, length - 0.1));
  const double offset = std::min(door_offset, std::max(0.0, 0.5 * (length - width)));
  Opening door;
  door.id = "door-0";
  door.type = OpeningType::door;
  door.wall = wall;
  door.from = at_from ? offset : length - offset - width;
  door.to = door.from + width;
  door.head = std::min(default_door_head, room.height);
  // The leaf opens against the wall beside it.
  door.hinge_at_from = at_from;
  door.swing = kind.swing;
  return door;
}

// Balconies are entered through the middle of the wall of the dwelling.
Opening door_in_middle(const Room& room, const RoomKind& kind, std::size_t wall, Random& random) {
  Opening door = door_in(room, kind, wall, true);
  const double length = room.polygon.edge(wall).length(), width = door.width();
  door.from = std::max(0.0, std::min(length - width, (length - width) * random.uniform(0.3, 0.7)));
  door.to = door.from + width;
  return door;
}

Opening window_in(const Room& room, const RoomKind& kind, std::size_t wall, bool wide,
                  Random& random) {
  const double length = room.polygon.edge(wall).length();
  double width = random.uniform(kind.windows.width.low, kind.windows.width.high);
  if (wide) width *= 1.5;
  width = std::min(width, length - 2.0 * window_margin);
  const double middle = length * random.uniform(0.42, 0.58);
  Opening window;
  window.type = OpeningType::window;
  window.wall = wall;
  window.from = std::clamp(middle - 0.5 * width, window_margin, length - window_margin - width);
  window.to = window.from + width;
  window.head = std::min(kind.windows.head, room.height - under_ceiling);
  window.sill = std::min(kind.windows.sill, window.head - 0.3);
  return window;
}

// Walls for windows: opposite the door first, then beside it, the door's own last.
std::vector<std::size_t> window_walls(std::size_t door_wall, Random& random) {
  const std::size_t side = random.chance(0.5) ? 1 : 3;
  return {(door_wall + 2) % 4, (door_wall + side) % 4, (door_wall + 4 - side) % 4};
}

std::size_t choose_door_wall(const RoomKind& kind, const Vec2& size, Random& random) {
  const bool wide = size.x() >= size.y();
  if (kind.door_on_long_side) return (wide ? 0u : 1u) + (random.chance(0.5) ? 2u : 0u);
  return static_cast<std::size_t>(random.integer(0, 3));
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
  return room.polygon.edge(wall).length() >= 2.0 * window_margin + 0.4;
}

}  // namespace

Vec2 choose_size(const RoomKind& kind, const Brief& brief, double scale, double furniture,
                 Random random) {
  if (brief.size) return *brief.size;
  if (brief.area) {
    const Vec2 size = of_area(*brief.area, kind, random);
    return {std::round(size.x() * 100) / 100, std::round(size.y() * 100) / 100};
  }
  Vec2 size(random.uniform(kind.width.low, kind.width.high),
            random.uniform(kind.depth.low, kind.depth.high));
  size *= scale;
  const double needed = furniture / std::max(0.1, kind.share.high);
  if (size.prod() < needed) size *= std::sqrt(needed / size.prod());
  if (size.prod() > max_chosen_area) size *= std::sqrt(max_chosen_area / size.prod());
  size = size.cwiseMax(kind.smallest).cwiseMin(20.0);
  size = Vec2(to_grid(size.x()), to_grid(size.y()));
  while (size.prod() > max_chosen_area + 1e-9) size.x() = to_grid(size.x() - 0.1);
  if (random.chance(0.3)) std::swap(size.x(), size.y());
  return size;
}

Room make_room(const RoomKind& kind, const Vec2& size, int windows, bool wide_windows,
               Random random) {
  Room room;
  room.type = kind.type;
  room.height = kind.height;
  room.polygon.points = {{0, 0}, {size.x(), 0}, {size.x(), size.y()}, {0, size.y()}};
  const std::size_t wall = choose_door_wall(kind, size, random);
  room.openings.push_back(kind.door_on_long_side ? door_in_middle(room, kind, wall, random)
                                                 : door_in(room, kind, wall, random.chance(0.5)));
  const auto walls = window_walls(wall, random);
  for (int i = 0; i < windows && i < static_cast<int>(walls.size()); ++i) {
    const std::size_t at = walls[static_cast<std::size_t>(i)];
    if (!takes_window(room, at)) continue;
    Opening window = window_in(room, kind, at, wide_windows, random);
    window.id = "window-" + std::to_string(room.openings.size() - 1);
    room.openings.push_back(window);
  }
  if (!kind.floors.empty()) room.materials.floor = random.pick(kind.floors);
  if (!kind.walls.empty()) room.materials.walls = random.pick(kind.walls);
  room.materials.ceiling = "white ceiling";
  return room;
}

void put_on(Room& room, const RoomMaterials& said) {
  const auto replace = [](std::string& has, const std::string& wanted) {
    if (!wanted.empty()) has = wanted;
  };
  replace(room.materials.floor, said.floor);
  replace(room.materials.walls, said.walls);
  replace(room.materials.ceiling, said.ceiling);
  replace(room.materials.accent, said.accent);
}

bool ensure_door(Room& room, const RoomKind& kind) {
  if (std::any_of(room.openings.begin(), room.openings.end(),
                  [](const Opening& opening) { return opening.is_entrance(); }))
    return false;
  const std::size_t longest = longest_bare_wall(room);
  if (longest == room.polygon.size()) return false;
  Opening door = door_in(room, kind, longest, true);
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
