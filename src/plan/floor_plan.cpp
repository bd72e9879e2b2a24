#include "floor_plan.h"

#include <algorithm>
#include <cmath>

#include "opening_measures.h"

namespace roomgen::design {

namespace {

constexpr double window_margin = 0.35;
// From the corner of a bay to its glass, and the least that is worth glazing.
constexpr double glazing_margin = 0.1, least_glazing = 0.3;
constexpr double bay_sill = 0.5;
// A leaf or the frame of a door needs so much of a wall beyond its width.
constexpr double door_margin = 0.1;

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

// In the proportions that the prompt asks for.
Vec2 of_proportion(double area, const Brief& brief, Random& random) {
  const double ratio = random.uniform(brief.shape.proportion->low, brief.shape.proportion->high);
  return box_of(area, ratio, true);
}

Opening door_in(const Room& room, const RoomKind& kind, std::size_t wall, bool at_from) {
  const double length = room.polygon.edge(wall).length();
  const double width = std::min(kind.door, std::max(0.3, length - 0.1));
  const double offset = std::min(corner_offset, std::max(0.0, 0.5 * (length - width)));
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

bool can_be_entered(const Room& room, const Opening& door) {
  return contains(room.polygon, door_clearance(room, door));
}

// At the end that is wanted if that is a corner of the room and people can pass there, else at the
// other, else in the middle.
Opening door_at_end(const Room& room, const RoomKind& kind, std::size_t wall, bool at_from) {
  for (const bool from : {at_from, !at_from}) {
    const std::size_t corner = from ? wall : (wall + 1) % room.polygon.size();
    const Opening door = door_in(room, kind, wall, from);
    if (room.polygon.is_convex_corner(corner) && can_be_entered(room, door)) return door;
  }
  Opening door = door_in(room, kind, wall, at_from);
  const double width = door.width();
  door.from = 0.5 * (room.polygon.edge(wall).length() - width);
  door.to = door.from + width;
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

// The whole of a bay's wall.
Opening glazing_in(const Room& room, const RoomKind& kind, std::size_t wall) {
  Opening window;
  window.type = OpeningType::window;
  window.wall = wall;
  window.from = glazing_margin;
  window.to = room.polygon.edge(wall).length() - glazing_margin;
  window.head = std::min(kind.windows.head, room.height - under_ceiling);
  window.sill = std::min({kind.windows.sill, bay_sill, window.head - 0.3});
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

bool is_glazed(const Outline& outline, std::size_t wall) {
  return std::find(outline.glazed.begin(), outline.glazed.end(), wall) != outline.glazed.end();
}

// Walls that take a door and before which there is room for it; the longest ones if none does.
std::vector<std::size_t> door_walls(const Room& room, const RoomKind& kind,
                                    const Outline& outline) {
  const Polygon& polygon = room.polygon;
  double longest = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    longest = std::max(longest, polygon.edge(k).length());
  std::vector<std::size_t> walls, long_ones;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double length = polygon.edge(k).length();
    if (length > longest - 1e-6) long_ones.push_back(k);
    if (!is_glazed(outline, k) && length >= kind.door + door_margin &&
        can_be_entered(room, door_at_end(room, kind, k, true)))
      walls.push_back(k);
  }
  return walls.empty() || kind.door_on_long_side ? long_ones : walls;
}

Opening make_door(const Room& room, const RoomKind& kind, const Outline& outline, Random& random) {
  const auto walls = door_walls(room, kind, outline);
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
  return room.polygon.edge(wall).length() >= 2.0 * window_margin + 0.4;
}

}  // namespace

Vec2 choose_size(const RoomKind& kind, const Brief& brief, double scale, double furniture,
                 Random random) {
  if (brief.size) return *brief.size;
  if (brief.area) {
    const Vec2 size = brief.shape.proportion ? of_proportion(*brief.area, brief, random)
                                             : of_area(*brief.area, kind, random);
    return {std::round(size.x() * 100) / 100, std::round(size.y() * 100) / 100};
  }
  const double depth = random.uniform(kind.depth.low, kind.depth.high);
  Vec2 size(random.uniform(kind.width.low, kind.width.high), depth);
  size *= scale;
  const double needed = furniture / std::max(0.1, kind.share.high);
  if (size.prod() < needed) size *= std::sqrt(needed / size.prod());
  if (size.prod() > max_chosen_area) size *= std::sqrt(max_chosen_area / size.prod());
  if (brief.shape.proportion) size = of_proportion(size.prod(), brief, random);
  size = size.cwiseMax(brief.shape.proportion ? 0.7 * kind.smallest : kind.smallest).cwiseMin(20.0);
  size = Vec2(to_grid(size.x()), to_grid(size.y()));
  while (size.prod() > max_chosen_area + 1e-9) size.x() = to_grid(size.x() - 0.1);
  if (random.chance(0.3)) std::swap(size.x(), size.y());
  return size;
}

Outline choose_outline(const Brief& brief, const Vec2& chosen, bool is_box,
                       std::vector<std::string>& notes, Random random) {
  const auto& shapes = built_in_floor_shapes();
  if (brief.shape.is_rectangle() || !shapes) return rectangle_of(chosen);
  OutlineSize size{chosen, std::nullopt};
  const auto known = shapes->outlines.find(brief.shape.outline);
  const double nooks = known == shapes->outlines.end() ? 1.0 : known->second.area;
  if (!is_box) size.area = brief.area ? *brief.area : nooks * chosen.prod();
  Outline outline = make_outline(brief.shape, *shapes, size, random);
  for (const auto& name : outline.missing)
    notes.push_back("no wall of a room of this size is long enough for the " + name);
  return outline;
}

Room make_room(const RoomKind& kind, const Outline& outline, int windows, bool wide_windows,
               Random random) {
  Room room;
  room.type = kind.type;
  room.height = kind.height;
  room.polygon = outline.polygon;
  room.openings.push_back(make_door(room, kind, outline, random));
  const auto add = [&](Opening window) {
    window.id = "window-" + std::to_string(room.openings.size() - 1);
    room.openings.push_back(std::move(window));
  };
  const std::size_t door_wall = room.openings[0].wall;
  for (const std::size_t wall : outline.glazed)
    if (wall != door_wall && room.polygon.edge(wall).length() > 2 * glazing_margin + least_glazing)
      add(glazing_in(room, kind, wall));
  // A bay is one of the windows.
  int left = windows - (room.openings.size() > 1 ? 1 : 0);
  for (const std::size_t wall : window_walls(room.polygon, door_wall, random)) {
    if (left <= 0) break;
    if (is_glazed(outline, wall)) continue;
    --left;
    if (takes_window(room, wall)) add(window_in(room, kind, wall, wide_windows, random));
  }
  if (!kind.floors.empty()) room.materials.floor = random.pick(kind.floors);
  if (!kind.walls.empty()) room.materials.walls = random.pick(kind.walls);
  room.materials.ceiling = "white ceiling";
  return room;
}

void put_on(Room& room, const StyleMeaning& style, Random random) {
  const auto choose = [&](std::string& has, const std::vector<std::string>& words) {
    if (!words.empty()) has = random.pick(words);
  };
  const bool is_tiled = room.materials.floor.find("tile") != std::string::npos;
  choose(room.materials.walls, style.walls);
  choose(room.materials.accent, style.accents);
  if (!is_tiled) choose(room.materials.floor, style.floors);
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

std::size_t wall_on_side(const Polygon& polygon, std::size_t side) {
  static const Vec2 outward[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  std::size_t best = 0;
  double most = -1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double facing = -polygon.inward(k).dot(outward[side % 4]);
    // A wall that hardly looks there is none of that side, however long.
    const double score = (facing > 0.7 ? 1e3 : 0.0) + facing * polygon.edge(k).length();
    if (score > most + 1e-9) best = k, most = score;
  }
  return best;
}

std::string part_of(const Room& room, const std::string& said) {
  for (std::size_t side = 0; side < 4; ++side)
    if (said == "wall-" + std::to_string(side))
      return "wall-" + std::to_string(wall_on_side(room.polygon, side));
  return said;
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
