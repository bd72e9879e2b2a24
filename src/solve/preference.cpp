#include <algorithm>
#include <cmath>

#include "surroundings.h"

namespace roomgen {

namespace {

// Metres: what is farther is not opposite any more.
constexpr double opposite = 3.5;

// 1 inside the range that the pair prefers, less with the distance to it.
double pair_gap_degree(const ResolvedRelation& relation, const Footprint& own) {
  double best = 0.0;
  for (const auto& target : relation.targets) {
    const double distance = gap(own, target);
    const double off = std::max({0.0, relation.gap_low - distance, distance - relation.gap_high});
    best = std::max(best, 1.0 / (1.0 + 3.0 * off));
  }
  return best;
}

// Between its front and the middle of the target, radians.
double angle_to(const Footprint& own, double turn, const Footprint& target) {
  const Vec2 towards = target.center() - own.center();
  return towards.norm() < 1e-9 ? 0.0
                               : std::abs(wrap_angle(yaw_facing(towards) - own.yaw() - turn));
}

// The middle of the room is a matter of degree, what is opposite is not out of sight, and what faces
// a thing looks at its middle.
double wish_degree(const Surroundings& around, const Surroundings::Wish& wish,
                   const Footprint& own) {
  const auto& targets = wish.relation.targets;
  switch (wish.relation.kind) {
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::around:
    case RelationKind::gap:
      return (wish.asked ? around.weights.asked_pair_gap : around.weights.pair_gap) *
             pair_gap_degree(wish.relation, own);
    case RelationKind::middle:
      return wish.asked ? around.weights.asked_middle * degree(around, own, 0.0, Preference::center) : 0.0;
    case RelationKind::far:
      return wish.asked && !targets.empty()
                 ? -around.weights.beyond_opposite *
                       std::max(0.0, gap(own, targets.front()) - opposite)
                 : 0.0;
    case RelationKind::face_to:
    case RelationKind::used_facing:
      return wish.asked && !targets.empty()
                 ? -around.weights.askew * angle_to(own, wish.relation.turn, targets.front())
                 : 0.0;
    default:
      return 0.0;
  }
}

// A rug lies where its group wants it, and turned as that is.
double beneath_degree(const Surroundings& around, const Footprint& own) {
  constexpr double exact = 0.02, parallel = 0.01;
  double best = 0.0;
  for (const auto& ideal : around.beneath)
    if ((own.center() - ideal.center()).norm() < exact)
      best = std::max(best, std::abs(wrap_angle(own.yaw() - ideal.yaw())) < parallel ? 1.0 : 0.5);
  return best;
}

bool is_at_seat(const Surroundings& around, const Footprint& own) {
  return std::any_of(around.seats.begin(), around.seats.end(),
                     [&](const SeatPlace& place) { return is_at(place, own); });
}

}  // namespace

double preference(const Surroundings& around, const Footprint& own, double bottom) {
  double sum = around.weights.reserve_open * reserve_open(around, own);
  for (const auto& one : around.arrangement.preferences)
    sum += one.weight * degree(around, own, bottom, one.what);
  if (!around.object.traits.flat && around.object.mount == Mount::floor) {
    sum -= around.weights.reserve_taken * reserves_taken(around, own);
    if (!around.arrangement.seats && is_on_crowded_side(around, own)) sum -= around.weights.crowded;
  }
  if (around.may_be_square) sum += around.weights.squareness * degree(around, own, bottom, Preference::square);
  for (const auto& wish : around.wishes) sum += wish_degree(around, wish, own);
  if (!around.beneath.empty()) sum += around.weights.over_place * beneath_degree(around, own);
  if (is_at_seat(around, own)) sum += around.weights.seat_place;
  return sum;
}

}  // namespace roomgen
