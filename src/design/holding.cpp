#include "holding.h"

#include <algorithm>
#include <cmath>

namespace roomgen::design {

namespace {

constexpr double at_wall = 0.05;
constexpr double off_walls = 0.30;
constexpr double at_second_wall = 0.10;
constexpr double near_gap = 1.5;
constexpr double around_gap = 0.6;
constexpr double aligned_offset = 0.05;
constexpr double angle_tolerance = pi / 180.0;

bool same_yaw(double a, double b) {
  return std::abs(wrap_angle(a - b)) <= angle_tolerance;
}

Vec2 middle_of_side(const Footprint& fp, Side side) {
  switch (side) {
    case Side::front:
      return fp.to_world({0, -fp.half().y()});
    case Side::back:
      return fp.to_world({0, fp.half().y()});
    case Side::left:
      return fp.to_world({fp.half().x(), 0});
    case Side::right:
      break;
  }
  return fp.to_world({-fp.half().x(), 0});
}

bool at_edge(const Room& room, const Footprint& fp) {
  const Vec2 back = middle_of_side(fp, Side::back);
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (same_yaw(fp.yaw(), yaw_facing(room.polygon.inward(k))) &&
        distance(room.polygon.edge(k), back) <= at_wall)
      return true;
  return false;
}

bool side_at_wall(const Room& room, const Footprint& fp) {
  for (Side side : {Side::left, Side::right}) {
    const Vec2 point = middle_of_side(fp, side);
    const Vec2 outward = (point - fp.center()).normalized();
    for (std::size_t k = 0; k < room.polygon.size(); ++k)
      if (room.polygon.inward(k).dot(outward) < -0.9 &&
          distance(room.polygon.edge(k), point) <= at_second_wall)
        return true;
  }
  return false;
}

// The centre in the target's frame, with the target's half size.
struct Local {
  Vec2 point;
  Vec2 half;
};

bool beside(const Local& local, double direction) {
  return direction * local.point.x() >= local.half.x() - 1e-6 &&
         std::abs(local.point.y()) <= local.half.y() + 1e-6;
}

bool ahead(const Local& local, double direction) {
  return direction * local.point.y() >= local.half.y() - 1e-6 &&
         std::abs(local.point.x()) <= local.half.x() + 1e-6;
}

bool aligned(const Local& local, const Relation& relation, const std::vector<Relation>& all) {
  bool lateral = false, longitudinal = false;
  for (const auto& other : all) {
    if (other.target != relation.target) continue;
    using K = RelationKind;
    if (other.kind == K::in_front_of || other.kind == K::behind) lateral = true;
    if (other.kind == K::left_of || other.kind == K::right_of || other.kind == K::side_of)
      longitudinal = true;
  }
  const bool x = std::abs(local.point.x()) <= aligned_offset;
  const bool y = std::abs(local.point.y()) <= aligned_offset;
  if (lateral) return x;
  if (longitudinal) return y;
  return x || y;
}

bool faces(const Placed& placed, const Target& target) {
  return ray_hit(target.footprint, placed.pose.position, front_direction(placed.pose.yaw)) >= 0;
}

bool over_each_other(const Local& local) {
  return std::abs(local.point.x()) <= local.half.x() && std::abs(local.point.y()) <= local.half.y();
}

bool holds_for(const Placed& placed, const Relation& relation, const std::vector<Relation>& all,
               const Target& target) {
  const Local local{target.footprint.to_local(placed.pose.position), target.footprint.half()};
  const double yaw = target.footprint.yaw();
  switch (relation.kind) {
    case RelationKind::near:
      return gap_to(placed, target) <= near_gap;
    case RelationKind::far:
      return gap_to(placed, target) >= near_gap;
    case RelationKind::in_front_of:
      return ahead(local, -1.0);
    case RelationKind::behind:
      return ahead(local, 1.0);
    case RelationKind::left_of:
      return beside(local, 1.0);
    case RelationKind::right_of:
      return beside(local, -1.0);
    case RelationKind::side_of:
      return beside(local, 1.0) || beside(local, -1.0);
    case RelationKind::around:
      return gap_to(placed, target) <= around_gap && faces(placed, target);
    case RelationKind::center_aligned:
    case RelationKind::aligned:
      return aligned(local, relation, all);
    case RelationKind::face_to:
      return faces(placed, target);
    case RelationKind::face_same_as:
      return same_yaw(placed.pose.yaw, yaw);
    case RelationKind::face_opposite_to:
      return same_yaw(placed.pose.yaw, yaw + pi);
    case RelationKind::on:
      return placed.self->mount == Mount::surface && over_each_other(local);
    case RelationKind::above:
      return over_each_other(local) && placed.bottom >= target.top - 1e-3;
    case RelationKind::under:
      return over_each_other(local) &&
             (placed.self->traits.flat || placed.bottom + placed.self->size.z() <= target.bottom);
    case RelationKind::hang_from:
      return true;
    case RelationKind::edge:
    case RelationKind::middle:
    case RelationKind::corner:
      break;
  }
  return false;
}

bool near_corner(const Sketch& sketch, const Placed& placed) {
  const auto& points = sketch.room().polygon.points;
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec2& point) { return gap(placed.footprint, point) <= near_gap; });
}

}  // namespace

double gap_to(const Placed& placed, const Target& target) {
  return gap(placed.footprint, target.footprint);
}

bool holds(const Sketch& sketch, const Placed& placed, const Relation& relation,
           const std::vector<Relation>& all) {
  const Room& room = sketch.room();
  switch (relation.kind) {
    case RelationKind::edge:
      return at_edge(room, placed.footprint);
    case RelationKind::corner:
      return at_edge(room, placed.footprint) && side_at_wall(room, placed.footprint);
    case RelationKind::middle:
      return distance_to_boundary(room.polygon, placed.footprint) >= off_walls;
    default:
      break;
  }
  if (relation.target == "corner") return near_corner(sketch, placed);
  const auto targets = sketch.find(relation.target);
  return !targets.empty() && holds_for(placed, relation, all, targets.front());
}

}  // namespace roomgen::design
