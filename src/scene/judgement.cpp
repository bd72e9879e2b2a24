#include "judgement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomgen {

namespace {

// Thresholds of docs/constraints.md.
constexpr double edge_gap = 0.05;
constexpr double middle_gap = 0.30;
constexpr double corner_gap = 0.10;
constexpr double near_gap = 1.5;
constexpr double beside_gap = 0.5;
constexpr double around_gap = 0.6;
constexpr double align_offset = 0.05;
constexpr double angle_tolerance = pi / 180.0;
constexpr double rounding = 1e-6;  // poses are stored with four decimals

// A rug is under the table that stands on it.
constexpr double flat_height = 0.05;
double clamp01(double value) {
  return std::clamp(value, 0.0, 1.0);
}

// How far the back of the footprint is from being flush with a wall that it is parallel to: its
// distance, or infinity for other walls.
double back_distance(const Footprint& footprint, const Room& room, std::size_t wall) {
  constexpr double none = std::numeric_limits<double>::infinity();
  static const double cosine = std::cos(angle_tolerance);
  const Segment line = room.polygon.edge(wall);
  const Vec2 along = line.b - line.a;
  const double squared = along.squaredNorm();
  // Positive when the front looks away from the wall; most walls are out at once.
  const double facing = footprint.front().dot(left_of(along));
  if (facing <= 0.0 || facing * facing < cosine * cosine * squared) return none;
  const Vec2 back = footprint.center() + footprint.half().y() * footprint.y_axis() - line.a;
  const double station = back.dot(along);
  if (station < 0.0 || station > squared) return none;
  return std::abs(cross(along, back)) / std::sqrt(squared);
}

// The wall that the back is nearest to, and how near.
std::pair<std::size_t, double> backing_wall(const Footprint& footprint, const Room& room) {
  std::size_t best = 0;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    const double d = back_distance(footprint, room, k);
    if (d < best_distance) best = k, best_distance = d;
  }
  return {best, best_distance};
}

Judgement judge_edge(const Footprint& footprint, const Room& room) {
  const double distance = backing_wall(footprint, room).second;
  return {distance <= edge_gap + rounding, clamp01(1.0 - distance / 1.0)};
}

Judgement judge_corner(const Footprint& footprint, const Room& room) {
  const auto [wall, distance] = backing_wall(footprint, room);
  const Vec2& half = footprint.half();
  const Segment left{footprint.to_world({half.x(), -half.y()}), footprint.to_world(half)};
  const Segment right{footprint.to_world(-half), footprint.to_world({-half.x(), half.y()})};
  double side_gap = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < room.polygon.size(); ++k) {
    if (k == wall) continue;
    const Segment line = room.polygon.edge(k);
    side_gap = std::min({side_gap, roomgen::distance(left, line), roomgen::distance(right, line)});
  }
  const bool held = distance <= edge_gap + rounding && side_gap <= corner_gap + rounding;
  return {held, 0.5 * clamp01(1.0 - distance) + 0.5 * clamp01(1.0 - side_gap / 2.0)};
}

Judgement judge_middle(const Footprint& footprint, const Room& room) {
  const double distance = distance_to_boundary(room.polygon, footprint);
  // A little more than the minimum is better than just the minimum.
  return {distance >= middle_gap - rounding, clamp01(distance / (2.0 * middle_gap))};
}

// From a region the pull reaches this far.
constexpr double region_reach = 4.0;

// Anywhere in it is in it.
Judgement judge_in_part(const Footprint& subject, const Footprint& region) {
  const Vec2 out = (region.to_local(subject.center()).cwiseAbs() - region.half()).cwiseMax(0.0);
  const double off = out.norm();
  const bool held = off <= rounding;
  return {held, held ? 1.0 : 0.7 * clamp01(1.0 - off / region_reach)};
}

double outside(double value, double low, double high) {
  return std::max({0.0, low - value, value - high});
}

Judgement judge_near(const ResolvedRelation& relation, double gap) {
  return {gap <= near_gap + rounding && gap >= relation.least_gap - rounding,
          clamp01(1.0 - outside(gap, relation.gap_low, relation.gap_high) / (2.0 * near_gap))};
}

// The slope ends where being near does, so that the search is drawn from afar.
Judgement judge_next_to(const ResolvedRelation& relation, double gap) {
  const double high = std::min(relation.gap_high, beside_gap);
  return {gap <= beside_gap + rounding,
          clamp01(1.0 - outside(gap, std::min(relation.gap_low, high), high) / near_gap)};
}

Judgement judge_far(double gap) {
  return {gap >= near_gap - rounding, clamp01(gap / (2.0 * near_gap))};
}

// Beyond one side of the target (`beyond` is the signed distance past it), at most `allowed` off
// the middle of that side.
Judgement judge_side(double beyond, double offset, double allowed) {
  const bool held = beyond >= -rounding && std::abs(offset) <= allowed + rounding;
  const double excess = std::max(0.0, std::abs(offset) - allowed);
  const double centred = clamp01(1.0 - 0.3 * std::abs(offset) / std::max(allowed, 1e-3));
  const double degree = held ? centred : 0.7 * clamp01(1.0 - excess - std::max(0.0, -beyond));
  return {held, degree};
}

Judgement judge_position(RelationKind kind, const Footprint& subject, const Footprint& target) {
  const Vec2 local = target.to_local(subject.center());
  const Vec2& half = target.half();
  const auto left = judge_side(local.x() - half.x(), local.y(), half.y());
  const auto right = judge_side(-local.x() - half.x(), local.y(), half.y());
  switch (kind) {
    case RelationKind::in_front_of:
      return judge_side(-local.y() - half.y(), local.x(), half.x());
    case RelationKind::behind:
      return judge_side(local.y() - half.y(), local.x(), half.x());
    case RelationKind::left_of:
      return left;
    case RelationKind::right_of:
      return right;
    default:
      break;
  }
  if (left.held != right.held) return left.held ? left : right;
  return left.degree >= right.degree ? left : right;
}

Judgement judge_aligned(AlignAxis axis, const Footprint& subject, const Footprint& target) {
  const Vec2 local = target.to_local(subject.center()).cwiseAbs();
  const double offset = axis == AlignAxis::lateral        ? local.x()
                        : axis == AlignAxis::longitudinal ? local.y()
                                                          : local.minCoeff();
  return {offset <= align_offset + rounding, clamp01(1.0 - offset)};
}

Judgement judge_face_to(const Footprint& subject, const Footprint& target) {
  const Vec2 to_target = target.center() - subject.center();
  const double distance = to_target.norm();
  const double cosine = distance > 1e-9 ? subject.front().dot(to_target) / distance : 0.0;
  return {ray_hit(target, subject.center(), subject.front()) >= 0.0, 0.5 + 0.5 * cosine};
}

Judgement judge_yaw(const Footprint& subject, double wanted) {
  const double difference = std::abs(wrap_angle(subject.yaw() - wanted));
  return {difference <= angle_tolerance, 1.0 - difference / pi};
}

Judgement judge_around(const ResolvedRelation& relation, const Footprint& subject,
                       const Footprint& target) {
  const double distance = gap(subject, target);
  const auto facing = judge_face_to(subject, target);
  const double off = outside(distance, relation.gap_low, std::min(relation.gap_high, around_gap));
  return {facing.held && distance <= around_gap + rounding,
          0.5 * facing.degree + 0.5 * clamp01(1.0 - off)};
}

// The centre between the two as seen along the line that joins them, and not aside of both.
Judgement judge_between(const Footprint& subject, const Footprint& a, const Footprint& b) {
  const Vec2 line = b.center() - a.center();
  const double length = line.norm();
  if (length < 1e-9) return {};
  const Vec2 along = line / length, across = left_of(along);
  const Vec2 from_a = subject.center() - a.center();
  const double low = reach_along(a, along), high = length - reach_along(b, along);
  const double off = std::abs(from_a.dot(across)), station = from_a.dot(along);
  const double allowed = std::max(reach_along(a, across), reach_along(b, across));
  const double past = outside(station, low, std::max(low, high));
  const bool held = high > low && past <= rounding && off <= allowed + rounding;
  const double askew = std::abs(station - 0.5 * (low + high)) + off;
  return {held, held ? 1.0 - 0.3 * clamp01(askew / (0.5 * (high - low) + allowed))
                     : 0.7 * clamp01(1.0 - past - std::max(0.0, off - allowed))};
}

Judgement judge_over(bool vertical, const Footprint& subject, const Footprint& target) {
  const auto within = [](const Footprint& a, const Footprint& b) {
    const Vec2 offset = a.to_local(b.center()).cwiseAbs() - a.half();
    return offset.maxCoeff() <= rounding;
  };
  const double apart = (target.center() - subject.center()).norm();
  return {vertical && (within(target, subject) || within(subject, target)),
          vertical ? clamp01(1.0 - apart) : 0.0};
}

// Anywhere on it is on it.
Judgement judge_on(const ResolvedRelation& relation, const Subject& subject,
                   const Footprint& target) {
  Judgement judgement = judge_over(subject.bottom <= relation.target_top + 0.02 &&
                                       subject.bottom >= relation.target_bottom,
                                   subject.footprint, target);
  if (judgement.held) judgement.degree = 1.0;
  return judgement;
}

// Its middle below the top of what contains it.
Judgement judge_inside(const ResolvedRelation& relation, const Subject& subject,
                       const Footprint& target) {
  const double middle = 0.5 * (subject.bottom + subject.top);
  const bool below_top = subject.bottom >= relation.target_bottom - rounding &&
                         middle <= relation.target_top + rounding;
  Judgement judgement = judge_over(true, subject.footprint, target);
  if (!below_top) judgement = {false, 0.5 * judgement.degree};
  return judgement;
}

Judgement judge_against(const ResolvedRelation& relation, const Subject& subject,
                        const Footprint& target, const Room& room) {
  const Footprint& own = subject.footprint;
  switch (relation.kind) {
    case RelationKind::edge:
      return judge_edge(own, room);
    case RelationKind::middle:
      return judge_middle(own, room);
    case RelationKind::corner:
      return judge_corner(own, room);
    case RelationKind::in_part:
      return judge_in_part(own, target);
    case RelationKind::near:
      return judge_near(relation, gap(own, target));
    case RelationKind::next_to:
      return judge_next_to(relation, gap(own, target));
    case RelationKind::far:
      return judge_far(gap(own, target));
    case RelationKind::in_front_of:
    case RelationKind::behind:
    case RelationKind::left_of:
    case RelationKind::right_of:
    case RelationKind::side_of:
      return judge_position(relation.kind, own, target);
    case RelationKind::around:
      return judge_around(relation, own, target);
    case RelationKind::between:
      return relation.other ? judge_between(own, target, *relation.other) : Judgement{};
    case RelationKind::center_aligned:
    case RelationKind::aligned:
      return judge_aligned(relation.axis, own, target);
    case RelationKind::face_to:
      return judge_face_to(own, target);
    case RelationKind::face_same_as:
      return judge_yaw(own, target.yaw());
    case RelationKind::face_opposite_to:
      return judge_yaw(own, target.yaw() + pi);
    case RelationKind::on:
      return judge_on(relation, subject, target);
    case RelationKind::inside:
      return judge_inside(relation, subject, target);
    case RelationKind::above:
      return judge_over(subject.bottom >= relation.target_top - rounding, own, target);
    case RelationKind::under:
      return judge_over(subject.top <= std::max(relation.target_bottom, flat_height) + rounding,
                        own, target);
    case RelationKind::hang_from: {
      const bool at_ceiling = std::abs(subject.top - room.height) < 0.02;
      return {at_ceiling || judge_edge(own, room).held, 1.0};
    }
  }
  return {};
}

}  // namespace

Judgement judge(const ResolvedRelation& relation, const Subject& subject, const Room& room) {
  Judgement best;
  for (const auto& target : relation.targets) {
    const Judgement judgement = judge_against(relation, subject, target, room);
    if (judgement.held > best.held ||
        (judgement.held == best.held && judgement.degree > best.degree))
      best = judgement;
  }
  return best;
}

std::vector<RelationVerdict> judge_scene(const Scene& scene, const KindTable& categories) {
  std::vector<RelationVerdict> verdicts;
  if (!scene.rooms.empty()) {
    for (const auto& part : parts_of(scene))
      for (auto& verdict : judge_scene(part, categories)) verdicts.push_back(std::move(verdict));
    return verdicts;
  }
  for (const auto& object : scene.objects) {
    const Subject subject{footprint(object), bottom(object), top(object)};
    const auto resolved = resolve(object, scene.room, scene.objects, categories);
    for (std::size_t i = 0; i < resolved.size(); ++i)
      verdicts.push_back({object.id, object.relations[i], judge(resolved[i], subject, scene.room)});
  }
  return verdicts;
}

}  // namespace roomgen
