#include "relation_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

namespace roomgen {

namespace {

// Thresholds of docs/constraints.md.
constexpr double edge_gap = 0.05;
constexpr double middle_gap = 0.30;
constexpr double corner_gap = 0.10;
constexpr double near_gap = 1.5;
constexpr double gap_tolerance = 0.10;  // the pitch of the grid of candidates
constexpr double beside_gap = 0.5;
constexpr double around_gap = 0.6;
constexpr double align_offset = 0.05;
constexpr double angle_tolerance = pi / 180.0;
constexpr double rounding = 1e-6;  // poses are stored with four decimals

// A rug is under the table that stands on it.
constexpr double flat_height = 0.05;
constexpr double at_ceiling = 0.02;

double clamp01(double value) {
  return std::clamp(value, 0.0, 1.0);
}

Vec2 seen_from_target(const RelationCase& one) {
  return one.target.to_local(one.own().center());
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

Judgement judge_edge(const RelationCase& one) {
  const double distance = backing_wall(one.own(), one.room).second;
  return {distance <= edge_gap + rounding, clamp01(1.0 - distance / 1.0)};
}

Judgement judge_corner(const RelationCase& one) {
  const Footprint& footprint = one.own();
  const Room& room = one.room;
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

Judgement judge_middle(const RelationCase& one) {
  const double distance = distance_to_boundary(one.room.polygon, one.own());
  // A little more than the minimum is better than just the minimum.
  return {distance >= middle_gap - rounding, clamp01(distance / (2.0 * middle_gap))};
}

// From a region the pull reaches this far.
constexpr double region_reach = 4.0;

// Anywhere in it is in it.
Judgement judge_in_part(const RelationCase& one) {
  const Vec2 out = (seen_from_target(one).cwiseAbs() - one.target.half()).cwiseMax(0.0);
  const double off = out.norm();
  const bool held = off <= rounding;
  return {held, held ? 1.0 : 0.7 * clamp01(1.0 - off / region_reach)};
}

double gap_of(const RelationCase& one) {
  if (!one.relation.at_back) return gap(one.own(), one.target);
  const Vec2 back = one.own().to_world({0.0, one.own().half().y()});
  const double distance = gap(one.target, back);
  return distance <= edge_gap + rounding ? 0.0 : near_gap + distance;
}

double outside(double value, double low, double high) {
  return std::max({0.0, low - value, value - high});
}

Judgement judge_near(const RelationCase& one) {
  const ResolvedRelation& relation = one.relation;
  const double gap = gap_of(one);
  return {gap <= near_gap + rounding && gap >= relation.least_gap - rounding,
          clamp01(1.0 - outside(gap, relation.gap_low, relation.gap_high) / (2.0 * near_gap))};
}

// The slope ends where being near does, so that the search is drawn from afar.
Judgement judge_next_to(const RelationCase& one) {
  const ResolvedRelation& relation = one.relation;
  const double gap = gap_of(one);
  const double high = std::min(relation.gap_high, beside_gap);
  return {gap <= beside_gap + rounding,
          clamp01(1.0 - outside(gap, std::min(relation.gap_low, high), high) / near_gap)};
}

Judgement judge_far(const RelationCase& one) {
  const double gap = gap_of(one);
  return {gap >= near_gap - rounding, clamp01(gap / (2.0 * near_gap))};
}

Judgement judge_gap(const RelationCase& one) {
  const double gap = one.relation.is_of_nearest_wall ? distance_to_boundary(one.room.polygon, one.own()) : gap_of(one);
  const double off = outside(gap, one.relation.gap_low, one.relation.gap_high);
  return {off <= gap_tolerance + rounding, clamp01(1.0 - off / near_gap)};
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

Judgement judge_in_front(const RelationCase& one) {
  const Vec2 local = seen_from_target(one);
  return judge_side(-local.y() - one.target.half().y(), local.x(), one.target.half().x());
}

Judgement judge_behind(const RelationCase& one) {
  const Vec2 local = seen_from_target(one);
  return judge_side(local.y() - one.target.half().y(), local.x(), one.target.half().x());
}

Judgement judge_left(const RelationCase& one) {
  const Vec2 local = seen_from_target(one);
  return judge_side(local.x() - one.target.half().x(), local.y(), one.target.half().y());
}

Judgement judge_right(const RelationCase& one) {
  const Vec2 local = seen_from_target(one);
  return judge_side(-local.x() - one.target.half().x(), local.y(), one.target.half().y());
}

Judgement judge_beside(const RelationCase& one) {
  const Judgement left = judge_left(one), right = judge_right(one);
  if (left.held != right.held) return left.held ? left : right;
  return left.degree >= right.degree ? left : right;
}

Judgement judge_aligned(const RelationCase& one) {
  const Vec2 local = seen_from_target(one).cwiseAbs();
  const AlignAxis axis = one.relation.axis;
  const double offset = axis == AlignAxis::lateral        ? local.x()
                        : axis == AlignAxis::longitudinal ? local.y()
                                                          : local.minCoeff();
  return {offset <= align_offset + rounding, clamp01(1.0 - offset)};
}

// By its front, or by the side that its use looks to.
Judgement judge_looking_at(const RelationCase& one) {
  const Footprint &subject = one.own(), &target = one.target;
  const double turn = one.relation.turn;
  const Vec2 look = turn == 0.0 ? subject.front() : rotated(subject.front(), turn);
  const Vec2 to_target = target.center() - subject.center();
  const double distance = to_target.norm();
  const double cosine = distance > 1e-9 ? look.dot(to_target) / distance : 0.0;
  return {ray_hit(target, subject.center(), look) >= 0.0, 0.5 + 0.5 * cosine};
}

Judgement judge_yaw(const Footprint& subject, double wanted) {
  const double difference = std::abs(wrap_angle(subject.yaw() - wanted));
  return {difference <= angle_tolerance, 1.0 - difference / pi};
}

Judgement judge_same_facing(const RelationCase& one) {
  return judge_yaw(one.own(), one.target.yaw());
}

Judgement judge_opposite_facing(const RelationCase& one) {
  return judge_yaw(one.own(), one.target.yaw() + pi);
}

Judgement judge_around(const RelationCase& one) {
  const double distance = gap_of(one);
  const auto facing = judge_looking_at(one);
  const double off =
      outside(distance, one.relation.gap_low, std::min(one.relation.gap_high, around_gap));
  return {facing.held && distance <= around_gap + rounding,
          0.5 * facing.degree + 0.5 * clamp01(1.0 - off)};
}

// The centre between the two as seen along the line that joins them, and not aside of both.
Judgement judge_between(const RelationCase& one) {
  if (!one.relation.other) return {};
  const Footprint &subject = one.own(), &a = one.target, &b = *one.relation.other;
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
Judgement judge_on(const RelationCase& one) {
  Judgement judgement = judge_over(one.subject.bottom <= one.relation.target_top + 0.02 &&
                                       one.subject.bottom >= one.relation.target_bottom,
                                   one.own(), one.target);
  if (judgement.held) judgement.degree = 1.0;
  return judgement;
}

// Its middle below the top of what contains it.
Judgement judge_inside(const RelationCase& one) {
  const double middle = 0.5 * (one.subject.bottom + one.subject.top);
  const bool below_top = one.subject.bottom >= one.relation.target_bottom - rounding &&
                         middle <= one.relation.target_top + rounding;
  Judgement judgement = judge_over(true, one.own(), one.target);
  if (!below_top) judgement = {false, 0.5 * judgement.degree};
  return judgement;
}

Judgement judge_above(const RelationCase& one) {
  return judge_over(one.subject.bottom >= one.relation.target_top - rounding, one.own(), one.target);
}

Judgement judge_under(const RelationCase& one) {
  const double top = std::max(one.relation.target_bottom, flat_height);
  return judge_over(one.subject.top <= top + rounding, one.own(), one.target);
}

// Its top under the target, or within its height as on a rail's hooks. What reaches up to the
// ceiling hangs there itself, and carries by its underside.
Judgement judge_hanging(const RelationCase& one) {
  constexpr double beside = 0.15;
  const double ceiling = one.room.height, top = one.subject.top;
  const double low = one.relation.target_bottom, high = one.relation.target_top;
  const bool is_thing = low > 0.0 || high < ceiling;
  if (!is_thing)
    return {judge_edge(one).held ? !one.relation.at_back || gap_of(one) <= edge_gap
                                 : std::abs(top - ceiling) < at_ceiling,
            1.0};
  const double aside = gap_of(one);
  const double off = outside(top, low, high > ceiling - at_ceiling ? low : high);
  const bool held = !one.relation.stands && aside <= beside + rounding && off < at_ceiling;
  return {held, held ? 1.0 : 0.7 * clamp01(1.0 - aside - off)};
}

using Relate = RelationKind;
using Sort = RelationSort;
using enum RelationDefinition::Trait;

constexpr RelationDefinition definitions[] = {
    {Relate::edge, Sort::wall, none, judge_edge, {"edge", "against wall"}},
    {Relate::middle, Sort::wall, none, judge_middle, {"middle", "center"}},
    {Relate::corner, Sort::wall, none, judge_corner, {"corner"}},
    {Relate::in_part, Sort::region, targeted, judge_in_part, {"in part"}},
    {Relate::near, Sort::distance, targeted | beside | in_prompts, judge_near, {"near", "close to"}},
    {Relate::next_to, Sort::distance, targeted | beside, judge_next_to, {"next to"}},
    {Relate::far, Sort::distance, targeted, judge_far, {"far", "far from"}},
    {Relate::gap, Sort::distance, targeted | beside, judge_gap, {"gap"}},
    {Relate::in_front_of, Sort::position, targeted | beside | in_prompts, judge_in_front, {"in front of"}},
    {Relate::behind, Sort::position, targeted | beside, judge_behind, {"behind"}},
    {Relate::left_of, Sort::position, targeted | beside | in_prompts, judge_left, {"left of", "to the left of"}},
    {Relate::right_of, Sort::position, targeted | beside | in_prompts, judge_right, {"right of", "to the right of"}},
    {Relate::side_of, Sort::position, targeted | beside, judge_beside, {"side of", "beside"}},
    {Relate::around, Sort::position, targeted | in_prompts, judge_around, {"around"}},
    {Relate::between, Sort::position, targeted | in_prompts, judge_between, {"between"}},
    {Relate::center_aligned, Sort::alignment, targeted | beside, judge_aligned,
     {"center aligned", "center align with", "center aligned with", "centre aligned", "centre aligned with",
      "centre align with"}},
    {Relate::aligned, Sort::alignment, targeted | beside, judge_aligned, {"aligned", "aligned with"}},
    {Relate::face_to, Sort::facing, targeted, judge_looking_at, {"face to", "facing", "face"}},
    {Relate::face_same_as, Sort::facing, targeted | beside, judge_same_facing, {"face same as"}},
    {Relate::face_opposite_to, Sort::facing, targeted | beside, judge_opposite_facing, {"face opposite to"}},
    {Relate::used_facing, Sort::facing, targeted, judge_looking_at, {"used facing"}},
    {Relate::on, Sort::support, targeted | in_prompts, judge_on, {"on", "on top of"}},
    {Relate::inside, Sort::support, targeted, judge_inside, {"inside", "within"}},
    {Relate::above, Sort::support, targeted, judge_above, {"above"}},
    {Relate::under, Sort::support, targeted | in_prompts, judge_under, {"under", "below"}},
    {Relate::hang_from, Sort::support, targeted, judge_hanging, {"hang from"}},
};

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < std::size(definitions); ++i)
    if (definitions[i].kind != static_cast<RelationKind>(i)) return false;
  return true;
}
static_assert(are_in_order(), "the rows stand in the order of the enumerators");

}  // namespace

std::span<const RelationDefinition> relation_definitions() {
  return definitions;
}

const RelationDefinition& definition(RelationKind kind) {
  assert(static_cast<std::size_t>(kind) < std::size(definitions));
  return definitions[static_cast<std::size_t>(kind)];
}

}  // namespace roomgen
