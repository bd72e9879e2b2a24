#include "roomgen/scene/room.h"

#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "roomgen/base/text.h"
#include "wall_sides.h"

namespace roomgen {

namespace {

// A door that does not swing in still needs a step of free floor behind it.
constexpr double step_depth = 0.6;
constexpr double opening_tolerance = 1e-6;
// Of its square, what an outline must fill: less is a slit.
constexpr double least_filled = 0.2;

Footprint strip_before(const Room& room, const Opening& opening, double depth) {
  const Segment line = segment(room, opening);
  const Vec2 normal = inward(room, opening);
  return Footprint(line.middle() + 0.5 * depth * normal, {opening.width(), depth},
                   yaw_facing(normal));
}

bool swings_in(const Opening& opening) {
  return opening.type == OpeningType::door && opening.swing == DoorSwing::in;
}

Error room_error(const Opening& opening, const std::string& what) {
  return {Error::Kind::invalid_input, "opening \"" + opening.id + "\": " + what};
}

Status check_opening(const Room& room, const Opening& opening) {
  if (opening.wall >= room.polygon.size())
    return room_error(opening, "wall " + std::to_string(opening.wall) + " does not exist; the room has " +
                                   std::to_string(room.polygon.size()) + " walls");
  const double length = room.polygon.edge(opening.wall).length();
  if (opening.from < -1e-3 || opening.to > length + 1e-3 || opening.width() < 0.1)
    return room_error(opening, "reaches from " + format_number(opening.from) + " to " +
                                   format_number(opening.to) + " on a wall of " +
                                   format_number(length) + " m");
  if (opening.sill < 0 || opening.head <= opening.sill || opening.head > room.height + 1e-3)
    return room_error(opening, "must have 0 <= sill < head <= room height");
  if (!opening.outline.empty() && !is_opening_outline(opening.outline))
    return room_error(opening, "its outline must be 3 to " + std::to_string(max_outline_points) +
                                   " points within [0, 1], counter-clockwise, that every upright "
                                   "line crosses once");
  return {};
}

// The leaf's edge draws a quarter circle around the hinge; beyond the approach it stays within this
// rectangle on the side of the hinge.
Footprint beyond_approach(const Room& room, const Opening& door, double leaf, bool at_from) {
  const Segment line = segment(room, door);
  const Vec2 hinge = at_from ? line.a : line.b;
  const Vec2 along = at_from ? line.direction() : Vec2(-line.direction());
  const double reach = std::sqrt(leaf * leaf - door_approach * door_approach);
  const Vec2 normal = inward(room, door);
  return Footprint(hinge + 0.5 * reach * along + 0.5 * (door_approach + leaf) * normal,
                   Vec2(reach, leaf - door_approach), yaw_facing(normal));
}

// How often the points turn from going right to going left or back, all the way round.
int count_turns(const std::vector<Vec2>& points) {
  int turns = 0;
  double last = 0.0;
  for (std::size_t i = 0; i < 2 * points.size(); ++i) {
    const double step = points[(i + 1) % points.size()].x() - points[i % points.size()].x();
    if (std::abs(step) < 1e-12) continue;
    // The first round only finds the direction.
    if (i >= points.size() && last * step < 0) ++turns;
    last = step;
  }
  return turns;
}

// Height of the chain of edges that go in this direction of x, at x.
double height_of_chain(const std::vector<Vec2>& points, double x, bool rightwards) {
  double height = rightwards ? -1e9 : 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    const double step = b.x() - a.x();
    if (std::abs(step) < 1e-12 || (step > 0) != rightwards) continue;
    if (x < std::min(a.x(), b.x()) - 1e-12 || x > std::max(a.x(), b.x()) + 1e-12) continue;
    const double z = a.y() + (x - a.x()) / step * (b.y() - a.y());
    height = rightwards ? std::max(height, z) : std::min(height, z);
  }
  return height;
}

}  // namespace

std::vector<Vec2> outline(const Opening& opening) {
  static const std::vector<Vec2> whole = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Vec2> points;
  for (const auto& p : opening.outline.empty() ? whole : opening.outline)
    points.emplace_back(opening.from + p.x() * opening.width(),
                        opening.sill + p.y() * (opening.head - opening.sill));
  return points;
}

bool is_opening_outline(const std::vector<Vec2>& points) {
  if (points.size() < 3 || points.size() > max_outline_points) return false;
  for (const auto& p : points)
    if (!(p.minCoeff() >= -1e-9 && p.maxCoeff() <= 1.0 + 1e-9)) return false;
  if (!(signed_area(points) >= least_filled) || count_turns(points) != 2) return false;
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return height_of_chain(points, p.x(), true) <= height_of_chain(points, p.x(), false) + 1e-9;
  });
}

Segment segment(const Room& room, const Opening& opening) {
  const Segment wall = room.polygon.edge(opening.wall);
  const Vec2 along = wall.direction();
  return {wall.a + opening.from * along, wall.a + opening.to * along};
}

Vec2 inward(const Room& room, const Opening& opening) {
  return room.polygon.inward(opening.wall);
}

Footprint door_clearance(const Room& room, const Opening& door) {
  return strip_before(room, door, swings_in(door) ? door_approach : step_depth);
}

Footprint window_clearance(const Room& room, const Opening& window) {
  return strip_before(room, window, window_strip);
}

std::vector<Footprint> clearances(const Room& room, const Opening& opening) {
  if (!opening.is_entrance()) return {window_clearance(room, opening)};
  std::vector<Footprint> areas = {door_clearance(room, opening)};
  const double leaf = opening.width() / std::max(1, opening.leaves);
  if (!swings_in(opening) || leaf <= door_approach) return areas;
  for (const bool at_from : {true, false})
    if (opening.leaves > 1 || at_from == opening.hinge_at_from)
      areas.push_back(beyond_approach(room, opening, leaf, at_from));
  return areas;
}

std::size_t accent_wall(const Room& room) {
  std::vector<int> holes(room.polygon.size(), 0);  // 1: windows alone, 2: an entrance
  for (const auto& opening : room.openings)
    if (opening.wall < holes.size())
      holes[opening.wall] = std::max(holes[opening.wall], opening.is_entrance() ? 2 : 1);
  std::size_t best = 0;
  for (std::size_t k = 1; k < holes.size(); ++k) {
    const double longer = room.polygon.edge(k).length() - room.polygon.edge(best).length();
    if (holes[k] < holes[best] || (holes[k] == holes[best] && longer > 1e-9)) best = k;
  }
  return best;
}

WallCover& cover_named(RoomMaterials& materials, std::string_view wall) {
  for (auto& cover : materials.covers)
    if (cover.wall == wall) return cover;
  return materials.covers.emplace_back(WallCover{std::string(wall), {}, {}});
}

std::string finish_named(const RoomMaterials& materials, std::string_view wall) {
  for (const auto& cover : materials.covers)
    if (cover.wall == wall) return cover.finish;
  return "";
}

WallCover cover_of(const Room& room, std::size_t wall) {
  WallCover found{"wall-" + std::to_string(wall), room.materials.walls, {}};
  bool is_said = false;
  for (const auto& cover : room.materials.covers) {
    if (cover.wall.empty() && !found.lower) found.lower = cover.lower;
    const auto meant = walls_named(room, cover.wall);
    if (is_said || std::find(meant.begin(), meant.end(), wall) == meant.end()) continue;
    is_said = true;
    if (!cover.finish.empty()) found.finish = cover.finish;
    if (cover.lower) found.lower = cover.lower;
  }
  if (found.lower && found.lower->height <= 0.0) found.lower.reset();
  return found;
}

const Opening* find_opening(const Room& room, std::string_view id) {
  for (const auto& opening : room.openings)
    if (opening.id == id) return &opening;
  return nullptr;
}

Status check(const Room& room) {
  if (room.polygon.size() < 3)
    return Error{Error::Kind::invalid_input, "room: the polygon needs at least three corners"};
  if (const Vec2 size = bounds(room.polygon).size(); size.prod() > largest_floor)
    return Error{Error::Kind::limit, "room: the rectangle round its floor is " + format_number(size.x()) + " x " +
                                         format_number(size.y()) + " m, and " + format_number(largest_floor) +
                                         " m2 is the most; are the lengths in metres?"};
  for (std::size_t i = 0; i < room.openings.size(); ++i) {
    const Opening& opening = room.openings[i];
    if (auto status = check_opening(room, opening); !status) return status;
    for (std::size_t j = 0; j < i; ++j) {
      const Opening& other = room.openings[j];
      if (other.id == opening.id) return room_error(opening, "there are two of this id");
      if (other.wall == opening.wall && other.from < opening.to - opening_tolerance &&
          opening.from < other.to - opening_tolerance && other.sill < opening.head &&
          opening.sill < other.head)
        return room_error(opening, "overlaps \"" + other.id + "\"");
    }
  }
  return {};
}

std::string_view name(OpeningType type) {
  switch (type) {
    case OpeningType::door: return "door";
    case OpeningType::window: return "window";
    case OpeningType::passage: return "passage";
  }
  return "";
}

std::string_view name(DoorSwing swing) {
  switch (swing) {
    case DoorSwing::in: return "in";
    case DoorSwing::out: return "out";
    case DoorSwing::sliding: return "sliding";
  }
  return "";
}

std::string_view name(Sky sky) {
  switch (sky) {
    case Sky::clear: return "clear";
    case Sky::cloudy: return "cloudy";
    case Sky::overcast: return "overcast";
    case Sky::night: return "night";
  }
  return "";
}

}  // namespace roomgen
