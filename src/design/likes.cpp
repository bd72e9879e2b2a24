#include "likes.h"

#include <algorithm>
#include <cmath>

namespace roomgen::design {

namespace {

constexpr std::array<Side, 4> all_sides = {Side::front, Side::back, Side::left, Side::right};

double falling(double value, double full, double none) {
  return std::clamp((none - value) / (none - full), 0.0, 1.0);
}

Vec2 box_middle(const Room& room) {
  const Bounds2 box = bounds(room.polygon);
  return 0.5 * (box.low + box.high);
}

double room_span(const Room& room) {
  return bounds(room.polygon).size().norm();
}

double nearest_opening(const Sketch& sketch, const Placed& placed, bool entrances) {
  double nearest = 1e9;
  for (const auto& opening : sketch.openings(entrances))
    nearest = std::min(nearest, gap_to(placed, opening));
  return nearest;
}

// 1 straight before a door, falling with distance and sideways.
double in_door_line(const Sketch& sketch, const Placed& placed) {
  double most = 0.0;
  for (const auto& door : sketch.openings(true)) {
    const Vec2 local = door.footprint.to_local(placed.pose.position);
    const double sideways = std::abs(local.x()) - door.footprint.half().x() -
                            0.5 * std::min(placed.self->size.x(), placed.self->size.y());
    most = std::max(most, falling(sideways, 0.0, 0.4) * falling(-local.y(), 1.5, 6.0));
  }
  return most;
}

double back_at_window(const Sketch& sketch, const Placed& placed) {
  double most = 0.0;
  const Vec2 back = placed.footprint.to_world({0, placed.footprint.half().y()});
  for (const auto& window : sketch.openings(false)) {
    const Vec2 local = window.footprint.to_local(back);
    if (std::abs(local.y()) > 0.6) continue;
    const double reach = window.footprint.half().x() + placed.footprint.half().x();
    most = std::max(most, falling(std::abs(local.x()), 0.4 * reach, reach));
  }
  return most;
}

double looks_at_window(const Sketch& sketch, const Placed& placed) {
  for (const auto& window : sketch.openings(false))
    for (double side : {-0.6, 0.0, 0.6}) {
      const Vec2 eye = placed.footprint.to_world({side * placed.footprint.half().x(), 0});
      if (ray_hit(window.footprint, eye, placed.footprint.front()) >= 0) return 1.0;
    }
  return 0.0;
}

// The wall at the back: its segment, and where along it the thing stands.
struct AtWall {
  Segment line;
  double along = 0.0;
  bool found = false;
};

AtWall wall_behind(const Sketch& sketch, const Placed& placed) {
  const Polygon& polygon = sketch.room().polygon;
  const Vec2 back = placed.footprint.to_world({0, placed.footprint.half().y()});
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Segment line = polygon.edge(k);
    if (polygon.inward(k).dot(placed.footprint.front()) > 0.99 && distance(line, back) < 0.1)
      return {line, (placed.pose.position - line.a).dot(line.direction()), true};
  }
  return {};
}

double window_in_wall(const Sketch& sketch, const Placed& placed) {
  const AtWall wall = wall_behind(sketch, placed);
  if (!wall.found) return 0.0;
  for (const auto& window : sketch.openings(false))
    if (distance(wall.line, window.footprint.center()) < 0.01) return 1.0;
  return 0.0;
}

double in_wall_middle(const Sketch& sketch, const Placed& placed) {
  const AtWall wall = wall_behind(sketch, placed);
  if (!wall.found) return 0.0;
  const double half = 0.5 * wall.line.length();
  return 1.0 - std::abs(wall.along - half) / half;
}

// How much of the wall, on one side of the thing, is free of doors and of things that stand there.
double wall_beside(const Sketch& sketch, const Placed& placed) {
  const AtWall wall = wall_behind(sketch, placed);
  if (!wall.found) return 0.0;
  constexpr double enough = 3.4, step = 0.2, deep = 0.62;
  double longest = 0.0;
  for (double direction : {1.0, -1.0}) {
    double free = 0.0;
    for (; free < enough; free += step) {
      const double along = direction * (placed.footprint.half().x() + free + 0.5 * step);
      const Vec2 foot =
          placed.footprint.to_world({along, placed.footprint.half().y() - 0.5 * deep});
      const Footprint part(foot, {step, deep - 0.02}, placed.pose.yaw);
      if (!contains(sketch.room().polygon, part) || sketch.blocked(part)) break;
    }
    longest = std::max(longest, free);
  }
  return std::min(1.0, longest / enough);
}

double side_at_wall(const Sketch& sketch, const Placed& placed) {
  double nearest = 1e9;
  for (double sign : {1.0, -1.0}) {
    const Vec2 side = placed.footprint.to_world({sign * placed.footprint.half().x(), 0});
    const Vec2 outward = (side - placed.pose.position).normalized();
    const Polygon& polygon = sketch.room().polygon;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      if (polygon.inward(k).dot(outward) < -0.9)
        nearest = std::min(nearest, distance(polygon.edge(k), side));
  }
  return falling(nearest, 0.05, 1.2);
}

double near_corner(const Sketch& sketch, const Placed& placed) {
  double nearest = 1e9;
  for (const Vec2& point : sketch.room().polygon.points)
    nearest = std::min(nearest, gap(placed.footprint, point));
  return falling(nearest, 0.15, 1.0);
}

// Nothing tall stands and nothing hangs before this part of the wall.
double bare(const Sketch& sketch, const Placed& placed) {
  for (const auto& one : sketch.standing())
    if (!one.object->traits.flat && top(*one.object) > placed.bottom - 0.3 &&
        gap(one.footprint, placed.footprint) < 0.25)
      return 0.0;
  return 1.0;
}

double out_of_the_way(const Sketch& sketch, const Placed& placed) {
  double nearest = 1e9;
  const Vec2 middle = box_middle(sketch.room());
  for (const auto& door : sketch.openings(true)) {
    const Vec2 step = door.footprint.center() + 1.0 * door.footprint.front();
    nearest = std::min(nearest, gap(placed.footprint, Segment{step, 0.5 * (step + middle)}));
  }
  return 1.0 - falling(nearest, 0.2, 1.5);
}

double far_from_like(const Sketch& sketch, const Placed& placed) {
  double nearest = 1e9;
  for (const auto& one : sketch.standing())
    if (sketch.categories().is_a(one.object->category, placed.self->category))
      nearest = std::min(nearest, gap(one.footprint, placed.footprint));
  return 1.0 - falling(nearest, 0.3, 0.6 * room_span(sketch.room()));
}

// How far one sees along the front, against what a seating group needs.
double view(const Sketch& sketch, const Placed& placed) {
  const Polygon& polygon = sketch.room().polygon;
  const Vec2 front = placed.footprint.front();
  const Vec2 eye = placed.footprint.to_world({0, -placed.footprint.half().y()});
  double free = 0.0;
  while (free < 4.0 && contains(polygon, Vec2(eye + free * front))) free += 0.1;
  return 1.0 - falling(free, 1.5, 3.2);
}

double parallel_to_walls(const Sketch& sketch, const Placed& placed) {
  const double angle = placed.pose.yaw - yaw_facing(sketch.room().polygon.inward(0));
  return std::abs(std::sin(2.0 * angle)) < 0.05 ? 1.0 : 0.0;
}

double along_room(const Sketch& sketch, const Placed& placed) {
  const Vec2 box = bounds(sketch.room().polygon).size();
  const bool room_wide = box.x() >= box.y(), wide = placed.self->size.x() >= placed.self->size.y();
  const bool turned = std::abs(std::sin(placed.pose.yaw)) > 0.7;
  return (wide != turned) == room_wide ? 1.0 : 0.0;
}

double free_flanks(const Sketch& sketch, const Placed& placed) {
  double free = 0.0;
  for (Side side : {Side::left, Side::right}) {
    const Footprint zone = zone_footprint(placed.footprint, {side, 0.25, {}});
    const bool open =
        contains(sketch.room().polygon, zone, 0.02) &&
        std::none_of(sketch.standing().begin(), sketch.standing().end(), [&](const Standing& one) {
          return !one.object->traits.flat && overlaps(one.footprint, zone, 0.02);
        });
    free += open ? 0.5 : 0.0;
  }
  return free;
}

// Between a seat and the screen or hearth that it looks at.
double out_of_screens(const Sketch& sketch, const Placed& placed) {
  for (const auto& screen : sketch.standing()) {
    if (!sketch.categories().is_any_of(screen.object->category, {"tv stand", "fireplace"}))
      continue;
    for (const auto& seat : sketch.standing())
      if (sketch.categories().is_a(seat.object->category, "sofa") &&
          gap(placed.footprint, Segment{screen.footprint.center(), seat.footprint.center()}) < 0.15)
        return 0.0;
  }
  return 1.0;
}

double in_rows(const Sketch& sketch, const Placed& placed) {
  double best = 0.0;
  for (const auto& one : sketch.standing()) {
    if (!sketch.categories().is_a(one.object->category, placed.self->category)) continue;
    const Vec2 local = one.footprint.to_local(placed.pose.position);
    if (std::abs(wrap_angle(one.footprint.yaw() - placed.pose.yaw)) > 0.05) continue;
    if (std::abs(local.x()) < 0.06 || std::abs(local.y()) < 0.06)
      best = std::max(best, falling(local.norm(), 1.0, 4.0));
  }
  return best;
}

// On the floor that the use of another thing needs.
bool in_use_zone(const Sketch& sketch, const Standing& one, const Object& self, const Vec2& point) {
  return std::any_of(one.zones.begin(), one.zones.end(), [&](const UseZone& zone) {
    return contains(zone_footprint(one.footprint, zone), point) &&
           !sketch.categories().is_any_of(self.category, zone.partners);
  });
}

}  // namespace

double degree(const Sketch& sketch, const Placed& placed, Liking liking) {
  const Room& room = sketch.room();
  switch (liking) {
    case Liking::door:
      return 1.0 - falling(nearest_opening(sketch, placed, true), 0.3, 0.7 * room_span(room));
    case Liking::door_line:
      return in_door_line(sketch, placed);
    case Liking::window:
      return falling(nearest_opening(sketch, placed, false), 0.3, 2.5);
    case Liking::window_behind:
      return back_at_window(sketch, placed);
    case Liking::window_ahead:
      return looks_at_window(sketch, placed);
    case Liking::window_wall:
      return window_in_wall(sketch, placed);
    case Liking::wall_middle:
      return in_wall_middle(sketch, placed);
    case Liking::side_wall:
      return side_at_wall(sketch, placed);
    case Liking::corner:
      return near_corner(sketch, placed);
    case Liking::wall_near:
      return falling(distance_to_boundary(room.polygon, placed.footprint), 0.06, 0.8);
    case Liking::run:
      return wall_beside(sketch, placed);
    case Liking::bare_wall:
      return bare(sketch, placed);
    case Liking::center:
      return 1.0 - std::min(1.0, (placed.pose.position - box_middle(room)).norm() /
                                     (0.5 * room_span(room)));
    case Liking::aside:
      return out_of_the_way(sketch, placed);
    case Liking::apart:
      return far_from_like(sketch, placed);
    case Liking::view:
      return view(sketch, placed);
    case Liking::square:
      return parallel_to_walls(sketch, placed);
    case Liking::angle:
      return 1.0 - parallel_to_walls(sketch, placed);
    case Liking::long_axis:
      return along_room(sketch, placed);
    case Liking::flank:
      return free_flanks(sketch, placed);
    case Liking::screen_free:
      return out_of_screens(sketch, placed);
    case Liking::rows:
      return in_rows(sketch, placed);
  }
  return 0.0;
}

double reserve_open(const Sketch& sketch, const Placed& placed, const Arrangement& arrangement) {
  double open = 0.0, total = 0.0;
  // What stands free with seats around it needs its reserve for those, not shared with others.
  const bool spacious = arrangement.reserve[0] > 0 && arrangement.reserve[1] > 0;
  for (Side side : all_sides) {
    const double depth = arrangement.reserve[static_cast<std::size_t>(side)];
    if (depth <= 0.0) continue;
    const Footprint zone = zone_footprint(placed.footprint, {side, depth, {}});
    for (double x : {-0.8, 0.0, 0.8})
      for (double y : {-0.9, 0.0, 0.9}) {
        const Vec2 point = zone.to_world({x * zone.half().x(), y * zone.half().y()});
        bool free = contains(sketch.room().polygon, point);
        for (const auto& one : sketch.standing())
          free = free && (one.object->traits.flat || !contains(one.footprint, point)) &&
                 !(spacious && in_use_zone(sketch, one, *placed.self, point));
        open += free ? 1.0 : 0.0;
        total += 1.0;
      }
  }
  return total > 0.0 ? open / total : 1.0;
}

double reserves_taken(const Sketch& sketch, const Placed& placed,
                      const std::vector<Relation>& relations) {
  double taken = 0.0;
  for (const auto& one : sketch.standing()) {
    if (std::any_of(relations.begin(), relations.end(),
                    [&](const Relation& relation) { return relation.target == one.object->id; }))
      continue;
    for (Side side : all_sides) {
      const double depth = one.arrangement->reserve[static_cast<std::size_t>(side)];
      if (depth <= 0.0) continue;
      const Footprint zone = zone_footprint(one.footprint, {side, depth, {}});
      int hits = 0;
      for (double x : {-0.8, -0.4, 0.0, 0.4, 0.8})
        for (double y : {-0.8, 0.0, 0.8})
          hits +=
              contains(placed.footprint, zone.to_world({x * zone.half().x(), y * zone.half().y()}));
      taken += hits / 15.0;
    }
  }
  return taken;
}

bool on_crowded_side(const Sketch& sketch, const Placed& placed,
                     const std::vector<Relation>& relations) {
  const auto side_of = [](const Footprint& fp, const Vec2& point) {
    const Vec2 local = fp.to_local(point).cwiseQuotient(fp.half());
    if (std::abs(local.x()) > std::abs(local.y())) return local.x() > 0 ? Side::left : Side::right;
    return local.y() > 0 ? Side::back : Side::front;
  };
  for (const auto& relation : relations)
    for (const auto& target : sketch.find(relation.target)) {
      if (!target.object) continue;
      const Side own = side_of(target.footprint, placed.pose.position);
      for (const auto& one : sketch.standing())
        if (one.object != target.object &&
            sketch.categories().is_a(one.object->category, placed.self->category) &&
            gap(one.footprint, target.footprint) < 0.7 &&
            side_of(target.footprint, one.footprint.center()) == own)
          return true;
    }
  return false;
}

int slivers(const Sketch& sketch, const Placed& placed, const std::vector<Relation>& relations) {
  const auto narrow = [](double width) { return width > 0.08 && width < 0.5; };
  int count = narrow(distance_to_boundary(sketch.room().polygon, placed.footprint)) ? 1 : 0;
  for (const auto& one : sketch.standing()) {
    if (one.object->traits.flat || one.object->mount != Mount::floor) continue;
    if (std::any_of(relations.begin(), relations.end(),
                    [&](const Relation& relation) { return relation.target == one.object->id; }))
      continue;
    count += narrow(gap(one.footprint, placed.footprint)) ? 1 : 0;
  }
  return count;
}

}  // namespace roomgen::design
