#include "suggestion.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

// So much nearer or farther a designer means "at the wall"; sizes are not quite as planned.
constexpr double nearly_flush = 0.06, nearly_inside = 0.09, still_edge = 0.0505;
constexpr double nearly_square = 5.0 * pi / 180.0;
constexpr double near_enough = 0.10;

bool stands_at_walls(const Object& object) {
  return object.mount == Mount::floor && !object.traits.flat && !object.traits.round;
}

bool means_wall(const Object& object) {
  return std::any_of(object.relations.begin(), object.relations.end(), [](const Relation& one) {
    return one.kind == RelationKind::edge || one.kind == RelationKind::corner;
  });
}

bool keeps_off_walls(const Object& object) {
  return std::any_of(object.relations.begin(), object.relations.end(),
                     [](const Relation& one) { return one.kind == RelationKind::middle; });
}

// The sides of the object, as turned by its yaw, that look along a direction: 0 where none does squarely.
double half_towards(const Object& object, double yaw, const Vec2& direction) {
  const Vec2 local = rotated(direction, -yaw).cwiseAbs();
  if (local.y() > std::cos(nearly_square)) return 0.5 * object.size.y();
  if (local.x() > std::cos(nearly_square)) return 0.5 * object.size.x();
  return 0.0;
}

// What stands with its back nearly at a wall is meant to be square to it.
void square_up(const Room& room, const Object& object, Suggestion& suggestion) {
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment wall = room.polygon.edge(k);
    const double yaw = yaw_facing(room.polygon.inward(k));
    const double gap =
        (*suggestion.location - wall.a).dot(room.polygon.inward(k)) - 0.5 * object.size.y();
    const bool near = gap <= nearly_flush && gap >= -nearly_inside;
    if (!suggestion.facing && near && means_wall(object)) suggestion.facing = yaw;
    if (suggestion.facing && (near || means_wall(object)) &&
        std::abs(wrap_angle(*suggestion.facing - yaw)) <= nearly_square)
      suggestion.facing = yaw;
  }
}

// Clear of a wall by up to so much, what is said squarely to it is meant so.
double kept_gap(const Object& object, const std::optional<double>& said, double squared) {
  if (!said || std::abs(wrap_angle(*said - squared)) > 1e-3) return 0.0;
  return means_wall(object) ? still_edge : nearly_flush;
}

void snap_to_walls(const Room& room, const Object& object, Suggestion& suggestion) {
  if (!suggestion.location || !stands_at_walls(object) || keeps_off_walls(object)) return;
  const auto said = suggestion.facing;
  square_up(room, object, suggestion);
  if (!suggestion.facing) return;
  const double kept = kept_gap(object, said, *suggestion.facing);
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const Segment wall = room.polygon.edge(k);
    const Vec2 inward = room.polygon.inward(k), from = *suggestion.location - wall.a;
    const double along = from.dot(wall.direction());
    const double half = half_towards(object, *suggestion.facing, inward);
    const double gap = from.dot(inward) - half;
    if (half <= 0.0 || along < 0.0 || along > wall.length()) continue;
    const bool is_kept = gap >= 0.0 && gap <= kept;
    if (gap <= nearly_flush && gap >= -nearly_inside && !is_kept)
      *suggestion.location += (flush - gap) * inward;
  }
}

void move_with_carrier(const Layout& layout, const PlacementTask& task, Suggestion& suggestion) {
  const Object* carrier = task.carrier_then ? layout.find(task.object.on) : nullptr;
  if (!carrier) return;
  const double turn = wrap_angle(carrier->yaw - task.carrier_then->yaw);
  if (suggestion.location)
    suggestion.location =
        carrier->position.head<2>() +
        rotated(Vec2(*suggestion.location - task.carrier_then->position), turn);
  if (suggestion.facing) suggestion.facing = wrap_angle(*suggestion.facing + turn);
}

}  // namespace

Suggestion suggestion_of(const Layout& layout, const PlacementTask& task) {
  Suggestion suggestion{task.location, task.facing, task.binding};
  move_with_carrier(layout, task, suggestion);
  if (suggestion.binds) snap_to_walls(layout.room(), task.object, suggestion);
  return suggestion;
}

double turn_between(const Object& object, double yaw, double wanted) {
  if (object.traits.round) return 0.0;
  const bool square = std::abs(object.size.x() - object.size.y()) < 1e-3;
  const double period = object.traits.front ? 2.0 * pi : square ? 0.5 * pi : pi;
  return std::abs(std::remainder(yaw - wanted, period));
}

bool follows(const Object& object, const Pose& pose, const Suggestion& suggestion) {
  return (!suggestion.location || (pose.position - *suggestion.location).norm() <= near_enough) &&
         (!suggestion.facing ||
          turn_between(object, pose.yaw, *suggestion.facing) <= nearly_square);
}

}  // namespace roomgen
