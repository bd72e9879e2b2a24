#include "roomgen/scene/room.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// A door that does not swing in still needs a step of free floor behind it.
constexpr double step_depth = 0.6;
constexpr double tolerance = 1e-6;

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
  return {};
}

}  // namespace

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
  const double leaf = opening.width();
  if (swings_in(opening) && leaf > door_approach) {
    // The leaf's edge draws a quarter circle around the hinge; beyond the approach it stays within this
    // rectangle on the side of the hinge.
    const Segment line = segment(room, opening);
    const Vec2 hinge = opening.hinge_at_from ? line.a : line.b;
    const Vec2 along = opening.hinge_at_from ? line.direction() : Vec2(-line.direction());
    const double reach = std::sqrt(leaf * leaf - door_approach * door_approach);
    const Vec2 normal = inward(room, opening);
    areas.emplace_back(hinge + 0.5 * reach * along + 0.5 * (door_approach + leaf) * normal,
                       Vec2(reach, leaf - door_approach), yaw_facing(normal));
  }
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

const Opening* find_opening(const Room& room, std::string_view id) {
  for (const auto& opening : room.openings)
    if (opening.id == id) return &opening;
  return nullptr;
}

Status check(const Room& room) {
  if (room.polygon.size() < 3)
    return Error{Error::Kind::invalid_input, "room: the polygon needs at least three corners"};
  for (std::size_t i = 0; i < room.openings.size(); ++i) {
    const Opening& opening = room.openings[i];
    if (auto status = check_opening(room, opening); !status) return status;
    for (std::size_t j = 0; j < i; ++j) {
      const Opening& other = room.openings[j];
      if (other.id == opening.id) return room_error(opening, "there are two of this id");
      if (other.wall == opening.wall && other.from < opening.to - tolerance &&
          opening.from < other.to - tolerance && other.sill < opening.head &&
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

}  // namespace roomgen
