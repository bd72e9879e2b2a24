#include <algorithm>
#include <cmath>
#include <optional>

#include "geometric_relations.h"
#include "object_relations.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::lab {

namespace {

constexpr double facing_deviation = 30.0;  // degrees, as SceneEval's face_to
constexpr double wall_deviation = 60.0;    // degrees
constexpr double leaf_distance = 0.15;     // metres, of a curtain before its window
constexpr double beside_range = 1.5;       // metres, as "near"
constexpr double beside_wall = 0.3;        // metres, as "against" a wall
constexpr double beside_deviation = 0.25;
constexpr double rug_height = 0.05;  // metres

template <typename Score>
double best_of(std::span<const Thing> parts, Score score) {
  double best = 0.0;
  for (const auto& part : parts) best = std::max(best, score(part.box()));
  return best;
}

// The edge of a wall or opening towards the room, seen from above.
Segment inner_edge(const OrientedBox& part) {
  return {part.to_world({-part.half.x(), -part.half.y(), 0}).head<2>(),
          part.to_world({part.half.x(), -part.half.y(), 0}).head<2>()};
}

// The middle of what the strip before the front meets of the part, in the frame of the thing.
std::optional<Vec2> seen(const OrientedBox& thing, const OrientedBox& part) {
  const Segment edge = inner_edge(part);
  Vec2 a = thing.to_local({edge.a.x(), edge.a.y(), 0}).head<2>();
  Vec2 b = thing.to_local({edge.b.x(), edge.b.y(), 0}).head<2>();
  if (a.x() > b.x()) std::swap(a, b);
  const double low = std::max(a.x(), -thing.half.x());
  const double high = std::min(b.x(), thing.half.x());
  if (low > high) return std::nullopt;
  const double x = 0.5 * (low + high);
  const double width = b.x() - a.x();
  const Vec2 middle = width > 0.0 ? Vec2(a + (x - a.x()) / width * (b - a)) : Vec2(0.5 * (a + b));
  if (middle.y() >= 0.0) return std::nullopt;  // behind
  return middle;
}

double squareness(double cosine, double deviation) {
  return std::clamp(1.0 - degrees(std::acos(std::clamp(cosine, -1.0, 1.0))) / deviation, 0.0, 1.0);
}

double facing(const OrientedBox& thing, const OrientedBox& part) {
  const auto point = seen(thing, part);
  if (!point || thing.front().dot(part.front()) >= 0.0) return 0.0;
  return squareness(-point->y() / point->norm(), facing_deviation);
}

// Of what the shorter of two intervals around their middles has, the share that is in both.
double common(double distance, double half_a, double half_b) {
  const double both = std::min(half_a, half_b);
  const double overlap = std::min(2.0 * both, half_a + half_b - std::abs(distance));
  return both > 0.0 ? std::max(0.0, overlap) / (2.0 * both) : 0.0;
}

// A thing in the frame of an opening: x along the wall, y out of the room, z up.
struct Before {
  Vec3 center, half;
  double distance;  ///< from the face of the wall; not positive when it reaches into it
};

Before before(const OrientedBox& thing, const OrientedBox& opening) {
  const Vec2 along = opening.to_world({1, 0, 0}).head<2>() - opening.center.head<2>();
  const Vec3 center = opening.to_local(thing.center);
  const Vec3 half(thing.half_extent(along), thing.half_extent(left_of(along)), thing.half.z());
  return {center, half, -center.y() - half.y() - opening.half.y()};
}

double covers(const OrientedBox& thing, const OrientedBox& opening) {
  const Before found = before(thing, opening);
  if (found.distance > leaf_distance || found.center.y() > opening.half.y()) return 0.0;
  return std::min(common(found.center.x(), found.half.x(), opening.half.x()),
                  common(found.center.z(), found.half.z(), opening.half.z()));
}

double beside(const OrientedBox& thing, const OrientedBox& opening, BoxSide side) {
  const Before found = before(thing, opening);
  if (found.distance > beside_wall || found.center.y() > opening.half.y()) return 0.0;
  const double x = side == BoxSide::right ? found.center.x() : -found.center.x();
  const double beyond = x + found.half.x() - opening.half.x();
  const double share = std::clamp(beyond / (2.0 * found.half.x()), 0.0, 1.0);
  const double gap = std::max(0.0, x - found.half.x() - opening.half.x());
  return share * sceneeval::distance_score(gap, 0.0, beside_range, beside_deviation);
}

}  // namespace

double face_opening(const Thing& thing, std::span<const Thing> openings) {
  return best_of(openings,
                 [&](const OrientedBox& opening) { return facing(thing.box(), opening); });
}

double face_wall(const Thing& thing, std::span<const Thing> walls) {
  return best_of(walls, [&](const OrientedBox& wall) {
    return std::min(facing(thing.box(), wall),
                    squareness(-thing.box().front().dot(wall.front()), wall_deviation));
  });
}

double on_opening(const Thing& thing, std::span<const Thing> openings) {
  return best_of(openings,
                 [&](const OrientedBox& opening) { return covers(thing.box(), opening); });
}

double beside_opening(const Thing& thing, std::span<const Thing> openings, BoxSide side) {
  return best_of(openings,
                 [&](const OrientedBox& opening) { return beside(thing.box(), opening, side); });
}

double on_floor(const Thing& thing) {
  return std::abs(thing.box().center.z() - thing.box().half.z()) <= rug_height ? 1.0 : 0.0;
}

}  // namespace roomgen::lab
