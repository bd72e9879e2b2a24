#include "dwelling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "roomgen/base/text.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

// How far inner faces may be from one wall's thickness and still be those of one wall.
constexpr double touch_tolerance = 1e-3;

Error dwelling_error(const std::string& what) {
  return {Error::Kind::invalid_input, "dwelling: " + what};
}

bool near_each_other(const Bounds2& a, const Bounds2& b) {
  return (a.low.array() < b.high.array() + wall_thickness).all() &&
         (b.low.array() < a.high.array() + wall_thickness).all();
}

// Between the outlines; 0 if one lies in the other.
double distance(const Polygon& a, const Polygon& b) {
  if (contains(a, b.points[0]) || contains(b, a.points[0])) return 0.0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      least = std::min(least, distance(a.edge(i), b.edge(j)));
  return least;
}

Status check_apart(const Room& a, const Room& b) {
  if (!near_each_other(bounds(a.polygon), bounds(b.polygon))) return {};
  const double gap = distance(a.polygon, b.polygon);
  if (gap > wall_thickness - touch_tolerance) return {};
  return dwelling_error("the rooms \"" + a.id + "\" and \"" + b.id + "\" are " +
                        format_number(gap) + " m apart; between them must be a wall of " +
                        format_number(wall_thickness) + " m");
}

Status check_links(std::span<const Room> rooms) {
  for (const auto& room : rooms)
    for (const auto& opening : room.openings) {
      if (opening.leads_to.empty()) continue;
      const std::string what = "\"" + opening.id + "\" of room \"" + room.id + "\" leads to \"" +
                               opening.leads_to + "\", ";
      if (!find_room(rooms, opening.leads_to))
        return dwelling_error(what + "which is no room of the dwelling");
      if (!other_side(rooms, room, opening))
        return dwelling_error(what + "which has no opening there that leads back");
    }
  return {};
}

bool meets(const Segment& a, const Segment& b) {
  // The other room sees the wall from its side, so its openings run the other way.
  return std::abs((a.a - b.b).norm() - wall_thickness) < touch_tolerance &&
         std::abs((a.b - b.a).norm() - wall_thickness) < touch_tolerance &&
         a.direction().dot(b.direction()) < 0;
}

}  // namespace

const Room* find_room(std::span<const Room> rooms, std::string_view id) {
  const auto found = std::find_if(rooms.begin(), rooms.end(),
                                  [&](const Room& room) { return room.id == id; });
  return found == rooms.end() ? nullptr : &*found;
}

const Opening* other_side(std::span<const Room> rooms, const Room& room, const Opening& opening) {
  const Room* next = find_room(rooms, opening.leads_to);
  if (!next) return nullptr;
  for (const auto& other : next->openings)
    if (other.leads_to == room.id && meets(segment(room, opening), segment(*next, other)))
      return &other;
  return nullptr;
}

Status check_dwelling(std::span<const Room> rooms) {
  if (rooms.size() > max_rooms)
    return dwelling_error("has " + std::to_string(rooms.size()) + " rooms; at most " +
                          std::to_string(max_rooms) + " are furnished");
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i].id.empty())
      return dwelling_error("room " + std::to_string(i) + " needs an \"id\"");
    if (auto status = check(rooms[i]); !status)
      return with_context(status.error(), "room \"" + rooms[i].id + "\"");
    for (std::size_t j = 0; j < i; ++j) {
      if (rooms[j].id == rooms[i].id)
        return dwelling_error("there are two rooms \"" + rooms[i].id + "\"");
      if (auto status = check_apart(rooms[j], rooms[i]); !status) return status;
    }
  }
  return check_links(rooms);
}

std::vector<SharedStretch> shared_stretches(std::span<const Room> rooms, std::size_t index) {
  std::vector<SharedStretch> stretches;
  const Polygon& own = rooms[index].polygon;
  for (std::size_t wall = 0; wall < own.size(); ++wall) {
    const Segment edge = own.edge(wall);
    const Vec2 along = edge.direction(), outward = -own.inward(wall);
    const auto is_behind = [&](const Vec2& p) {
      return std::abs((p - edge.a).dot(outward) - wall_thickness) < touch_tolerance;
    };
    for (std::size_t other = 0; other < rooms.size(); ++other) {
      if (other == index) continue;
      for (std::size_t k = 0; k < rooms[other].polygon.size(); ++k) {
        const Segment facing = rooms[other].polygon.edge(k);
        if (!is_behind(facing.a) || !is_behind(facing.b) || along.dot(facing.direction()) > 0)
          continue;
        const double from = std::max(0.0, (facing.b - edge.a).dot(along));
        const double to = std::min(edge.length(), (facing.a - edge.a).dot(along));
        if (to > from + touch_tolerance) stretches.push_back({wall, from, to, other});
      }
    }
  }
  return stretches;
}

std::vector<std::string> rooms_without_access(std::span<const Room> rooms) {
  std::set<std::string, std::less<>> open;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& room : rooms)
      for (const auto& opening : room.openings)
        if (opening.is_entrance() && (opening.leads_to.empty() || open.count(opening.leads_to)))
          changed = open.insert(room.id).second || changed;
  }
  std::vector<std::string> closed;
  for (const auto& room : rooms)
    if (!open.count(room.id)) closed.push_back(room.id);
  return closed;
}

}  // namespace roomgen
