#include <algorithm>
#include <cmath>
#include <optional>

#include "surroundings.h"

namespace roomgen {

namespace {

// The ranges below are by judgement, in metres: over which a preference (data/arrangements.json) goes from all to
// nothing. What they are worth against each other is `Weights` and the kind's own weight.
constexpr double far_away = 1e9;

double falling(double value, double full, double none) {
  return std::clamp((none - value) / (none - full), 0.0, 1.0);
}

double nearest_gap(std::span<const Footprint> others, const Footprint& own) {
  double nearest = far_away;
  for (const auto& other : others) nearest = std::min(nearest, gap(own, other));
  return nearest;
}

Vec2 back_of(const Footprint& own) {
  return own.to_world({0, own.half().y()});
}

// 1 straight before a door, falling with distance and sideways.
double in_door_line(const Surroundings& around, const Footprint& own) {
  double most = 0.0;
  for (const auto& door : around.doors) {
    const Vec2 local = door.to_local(own.center());
    const double sideways = std::abs(local.x()) - door.half().x() - own.half().minCoeff();
    most = std::max(most, falling(sideways, 0.0, 0.4) * falling(-local.y(), 1.5, 6.0));
  }
  return most;
}

// 1 when the front looks at the nearest door, 0 when the back does.
double looks_to_door(const Surroundings& around, const Footprint& own) {
  const auto nearer = [&](const Footprint& a, const Footprint& b) { return gap(a, own) < gap(b, own); };
  const auto door = std::min_element(around.doors.begin(), around.doors.end(), nearer);
  if (door == around.doors.end()) return 0.0;
  const Vec2 towards = door->center() - own.center();
  return towards.norm() < 1e-9 ? 0.0 : 0.5 + 0.5 * own.front().dot(towards.normalized());
}

double back_at_window(const Surroundings& around, const Footprint& own) {
  constexpr double at_wall = 0.6, full = 0.4;
  double most = 0.0;
  for (const auto& window : around.windows) {
    const Vec2 local = window.to_local(back_of(own)).cwiseAbs();
    if (local.y() > at_wall) continue;
    const double reach = window.half().x() + own.half().x();
    most = std::max(most, falling(local.x(), full * reach, reach));
  }
  return most;
}

double looks_at_window(const Surroundings& around, const Footprint& own) {
  for (const auto& window : around.windows)
    for (double side : {-0.6, 0.0, 0.6})
      if (ray_hit(window, own.to_world({side * own.half().x(), 0}), own.front()) >= 0) return 1.0;
  return 0.0;
}

// The wall at the back.
std::optional<Segment> wall_behind(const Surroundings& around, const Footprint& own) {
  constexpr double touching = 0.1, parallel = 0.99;
  const Polygon& polygon = around.room.polygon;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (polygon.inward(k).dot(own.front()) > parallel &&
        distance(polygon.edge(k), back_of(own)) < touching)
      return polygon.edge(k);
  return std::nullopt;
}

double window_in_wall(const Surroundings& around, const Footprint& own) {
  const auto wall = wall_behind(around, own);
  return wall && std::any_of(around.windows.begin(), around.windows.end(),
                             [&](const Footprint& window) {
                               return distance(*wall, window.center()) < 0.01;
                             })
             ? 1.0
             : 0.0;
}

double in_wall_middle(const Surroundings& around, const Footprint& own) {
  const auto wall = wall_behind(around, own);
  if (!wall) return 0.0;
  const double half = 0.5 * wall->length();
  return 1.0 - std::abs((own.center() - wall->a).dot(wall->direction()) - half) / half;
}

bool is_taken(const Surroundings& around, const Footprint& part) {
  return !contains(around.room.polygon, part) ||
         std::any_of(around.door_areas.begin(), around.door_areas.end(),
                     [&](const Footprint& area) { return overlaps(part, area); }) ||
         std::any_of(around.neighbours.begin(), around.neighbours.end(), [&](const auto& one) {
           return one.on_floor && !one.flat && overlaps(part, one.footprint);
         });
}

// How much of the wall, on one side of the thing, is free of doors and of things that stand there.
double wall_beside(const Surroundings& around, const Footprint& own) {
  if (!wall_behind(around, own)) return 0.0;
  constexpr double enough = 3.4, step = 0.2, deep = 0.62, slack = 0.02;
  double longest = 0.0;
  for (double direction : {1.0, -1.0}) {
    double free = 0.0;
    for (; free < enough; free += step) {
      const double along = direction * (own.half().x() + free + 0.5 * step);
      const Vec2 foot = own.to_world({along, own.half().y() - 0.5 * deep});
      if (is_taken(around, Footprint(foot, {step - slack, deep - slack}, own.yaw()))) break;
    }
    longest = std::max(longest, free);
  }
  return std::min(1.0, longest / enough);
}

double side_at_wall(const Surroundings& around, const Footprint& own) {
  constexpr double along = -0.9, touching = 0.05, lost = 1.2;
  const Polygon& polygon = around.room.polygon;
  double nearest = far_away;
  for (double sign : {1.0, -1.0}) {
    const Vec2 side = own.to_world({sign * own.half().x(), 0});
    for (std::size_t k = 0; k < polygon.size(); ++k)
      if (polygon.inward(k).dot(sign * own.x_axis()) < along)
        nearest = std::min(nearest, distance(polygon.edge(k), side));
  }
  return falling(nearest, touching, lost);
}

double near_corner(const Surroundings& around, const Footprint& own) {
  constexpr double in_corner = 0.15, lost = 1.0;
  double nearest = far_away;
  for (const Vec2& point : around.room.polygon.points) nearest = std::min(nearest, gap(own, point));
  return falling(nearest, in_corner, lost);
}

// Nothing tall stands and nothing hangs before this part of the wall.
double bare(const Surroundings& around, const Footprint& own, double bottom) {
  constexpr double below = 0.3, before = 0.25;
  return std::none_of(around.neighbours.begin(), around.neighbours.end(),
                      [&](const auto& one) {
                        return !one.flat && one.top > bottom - below && gap(one.footprint, own) < before;
                      })
             ? 1.0
             : 0.0;
}

// Off the way from the doors to the middle.
double out_of_the_way(const Surroundings& around, const Footprint& own) {
  double nearest = far_away;
  for (const auto& door : around.doors) {
    const Vec2 step = door.center() + 1.0 * door.front();
    nearest = std::min(nearest, gap(own, Segment{step, 0.5 * (step + around.middle)}));
  }
  return 1.0 - falling(nearest, 0.2, 1.5);
}

double far_from_like(const Surroundings& around, const Footprint& own) {
  double nearest = far_away;
  for (const auto& one : around.neighbours)
    if (one.like) nearest = std::min(nearest, gap(one.footprint, own));
  return 1.0 - falling(nearest, 0.3, 0.6 * around.span);
}

// How far one sees along the front, against what a seating group needs.
double view(const Surroundings& around, const Footprint& own) {
  constexpr double step = 0.1, enough = 3.2, least = 1.5;
  const Vec2 eye = own.to_world({0, -own.half().y()});
  double free = 0.0;
  while (free < enough && around.inside.contains(eye + free * own.front())) free += step;
  return 1.0 - falling(free, least, enough);
}

double parallel_to_walls(const Surroundings& around, const Footprint& own) {
  const double angle = own.yaw() - yaw_facing(around.room.polygon.inward(0));
  return std::abs(std::sin(2.0 * angle)) < 0.05 ? 1.0 : 0.0;
}

double along_room(const Surroundings& around, const Footprint& own) {
  const Vec2 box = bounds(around.room.polygon).size();
  const bool room_wide = box.x() >= box.y(), wide = own.half().x() >= own.half().y();
  const bool turned = std::abs(std::sin(own.yaw())) > 0.7;
  return (wide != turned) == room_wide ? 1.0 : 0.0;
}

double free_flanks(const Surroundings& around, const Footprint& own) {
  constexpr double depth = 0.25, slack = 0.02;
  double free = 0.0;
  for (Side side : {Side::left, Side::right}) {
    const Footprint zone = zone_footprint(own, {side, depth, {}});
    const bool open = contains(around.room.polygon, zone, slack) &&
                      std::none_of(around.neighbours.begin(), around.neighbours.end(),
                                   [&](const auto& one) {
                                     return !one.flat && overlaps(one.footprint, zone, slack);
                                   });
    free += open ? 0.5 : 0.0;
  }
  return free;
}

double out_of_sight_lines(const Surroundings& around, const Footprint& own) {
  constexpr double margin = 0.15;
  return std::none_of(around.sight_lines.begin(), around.sight_lines.end(),
                      [&](const Segment& line) { return gap(own, line) < margin; })
             ? 1.0
             : 0.0;
}

double in_line_with_like(const Surroundings& around, const Footprint& own) {
  constexpr double straight = 0.05, in_line = 0.06;
  double best = 0.0;
  for (const auto& one : around.neighbours) {
    if (!one.like || std::abs(wrap_angle(one.footprint.yaw() - own.yaw())) > straight) continue;
    const Vec2 local = one.footprint.to_local(own.center());
    if (local.cwiseAbs().minCoeff() < in_line) best = std::max(best, falling(local.norm(), 1.0, 4.0));
  }
  return best;
}

double in_middle(const Surroundings& around, const Footprint& own) {
  return 1.0 - std::min(1.0, (own.center() - around.middle).norm() / (0.5 * around.span));
}

}  // namespace

double degree(const Surroundings& around, const Footprint& own, double bottom,
              Preference preference) {
  // As good as at it up to here, of no worth from there.
  constexpr double beside = 0.3, window_light = 2.5, door_share = 0.7, at_wall = 0.06, off_wall = 0.8;
  switch (preference) {
    case Preference::door:
      return 1.0 - falling(nearest_gap(around.doors, own), beside, door_share * around.span);
    case Preference::door_line:
      return in_door_line(around, own);
    case Preference::door_ahead:
      return looks_to_door(around, own);
    case Preference::window:
      return falling(nearest_gap(around.windows, own), beside, window_light);
    case Preference::window_behind:
      return back_at_window(around, own);
    case Preference::window_ahead:
      return looks_at_window(around, own);
    case Preference::window_wall:
      return window_in_wall(around, own);
    case Preference::wall_middle:
      return in_wall_middle(around, own);
    case Preference::side_wall:
      return side_at_wall(around, own);
    case Preference::corner:
      return near_corner(around, own);
    case Preference::wall_near:
      return falling(distance_to_boundary(around.room.polygon, own), at_wall, off_wall);
    case Preference::run:
      return wall_beside(around, own);
    case Preference::bare_wall:
      return bare(around, own, bottom);
    case Preference::center:
      return in_middle(around, own);
    case Preference::aside:
      return out_of_the_way(around, own);
    case Preference::apart:
      return far_from_like(around, own);
    case Preference::view:
      return view(around, own);
    case Preference::square:
      return parallel_to_walls(around, own);
    case Preference::angle:
      return 1.0 - parallel_to_walls(around, own);
    case Preference::long_axis:
      return along_room(around, own);
    case Preference::flank:
      return free_flanks(around, own);
    case Preference::screen_free:
      return out_of_sight_lines(around, own);
    case Preference::rows:
      return in_line_with_like(around, own);
  }
  return 0.0;
}

}  // namespace roomgen
