#include "room_relations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "object_relations.h"

namespace roomgen::lab::sceneeval {

namespace {

constexpr double deviation = 0.25;
constexpr double corner_range = 0.8;
constexpr double square = 0.15;  // the cosine of the directions to two walls of a corner
constexpr int direction_grid = 6;

double best_distance_score(const Thing& thing, std::span<const Thing> parts, double low,
                           double high) {
  double best = 0.0;
  for (const auto& part : parts)
    best = std::max(best,
                    distance_score(part.distance_from(thing.box()), low, high, deviation));
  return best;
}

double before_wall(const Thing& thing, std::span<const Thing> walls, double range, double falloff) {
  const auto points = thing.box().points();
  double best = 0.0;
  for (const auto& wall : walls) {
    const auto before = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
      return wall.box().at_side(p, BoxSide::front, true, exact_margin);
    });
    if (before == 0) continue;
    best = std::max(best, static_cast<double>(before) / static_cast<double>(points.size()) *
                              distance_score(wall.distance_from(thing.box()), 0.0, range, falloff));
  }
  return best;
}

Vec3 mean_direction(const Thing& thing, const Thing& wall) {
  Vec3 sum = Vec3::Zero();
  for (const auto& point : thing.box().points(direction_grid)) sum += wall.closest_point(point) - point;
  return sum.norm() > 1e-12 ? Vec3(sum.normalized()) : sum;
}

}  // namespace

double inside_room(const Thing& thing, const Room& room) {
  const auto points = thing.box().points();
  const auto inside = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    return p.z() >= -1e-6 && contains(room.polygon, Vec2(p.head<2>()));
  });
  return static_cast<double>(inside) / static_cast<double>(points.size());
}

double middle_of_room(const Thing& thing, const Room& room) {
  const Bounds2 floor = bounds(room.polygon);
  const double distance =
      (0.5 * (floor.low + floor.high) - thing.box().center.head<2>()).norm();
  const double room_size = floor.size().mean();
  const double size = 2.0 * thing.box().half.head<2>().maxCoeff();
  const double spread = 0.5 * size + (1.0 - size / room_size);
  return std::exp(-distance * distance / (2.0 * spread * spread));
}

double next_to(const Thing& thing, std::span<const Thing> parts) {
  return best_distance_score(thing, parts, 0.0, 0.5);
}
double near(const Thing& thing, std::span<const Thing> parts) {
  return best_distance_score(thing, parts, 0.5, 1.5);
}
double across_from(const Thing& thing, std::span<const Thing> parts) {
  return best_distance_score(thing, parts, 1.5, 4.0);
}
double far(const Thing& thing, std::span<const Thing> parts) {
  return best_distance_score(thing, parts, 4.0, std::numeric_limits<double>::infinity());
}

double on_wall(const Thing& thing, std::span<const Thing> walls) {
  return before_wall(thing, walls, 0.01, 0.01);
}
double against_wall(const Thing& thing, std::span<const Thing> walls) {
  return before_wall(thing, walls, 0.3, 0.1);
}

double corner_of_room(const Thing& thing, std::span<const Thing> walls, const Room& room) {
  if (inside_room(thing, room) < 0.5) return 0.0;
  std::vector<double> scores;
  std::vector<Vec3> directions;
  for (const auto& wall : walls) {
    scores.push_back(
        distance_score(wall.distance_from(thing.box()), 0.0, corner_range, deviation));
    directions.push_back(mean_direction(thing, wall));
  }
  double best = 0.0;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(directions[i].dot(directions[j])) < square)
        best = std::max(best, scores[i] * scores[j]);
  return best;
}

double hang_from_ceiling(const Thing& thing, const Room& room) {
  // The ceiling is a sheet: a thing that reaches through it touches it.
  const double top = thing.box().center.z() + thing.box().half.z();
  const double bottom = top - 2.0 * thing.box().half.z();
  const double distance = room.height > top      ? room.height - top
                          : room.height < bottom ? bottom - room.height
                                                 : 0.0;
  return distance_score(distance, 0.0, 0.01, 0.03);
}

}  // namespace roomgen::lab::sceneeval
