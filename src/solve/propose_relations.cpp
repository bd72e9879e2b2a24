#include "proposals.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "scene/relation_table.h"

namespace roomgen {

namespace {

// The gaps to a target that are worth trying.
std::vector<double> useful_gaps(const ProposalContext& context, const ResolvedRelation& relation) {
  constexpr double farther = 0.5;  // where there is no most
  const double high = std::isinf(relation.gap_high) ? relation.gap_low + farther : relation.gap_high;
  std::vector<double> gaps = {relation.gap_low + flush,
                              0.5 * (relation.gap_low + high),
                              high,
                              0.3,
                              0.6,
                              0.9,
                              1.2};
  if (context.task.object.mount == Mount::surface)
    return {relation.gap_low + apart_on_surface, high, 0.01, 0.03, 0.06, 0.1, 0.2};
  if (context.layout.may_tuck(context.layout.categories().get(context.task.object.category),
                              context.layout.categories().get("table")))
    gaps.insert(gaps.end(), {-0.10, -0.20});
  return gaps;
}

// What the relations with one target leave open: on which sides of it, turned how against it.
struct Beside {
  bool sides[4] = {true, true, true, true};  // front, back, left, right
  bool turns[4] = {true, true, true, true};  // quarter turns of the yaw against the target's
  bool faces_target = false;
  int quarters = 0;  // from its front to the side that shall face the target
};

void keep_only(bool (&flags)[4], std::initializer_list<int> kept) {
  bool result[4] = {};
  for (int i : kept) result[i] = flags[i];
  std::copy(result, result + 4, flags);
}

Beside beside_target(const ProposalContext& context, const Vec2& target) {
  Beside beside;
  for (const auto& relation : context.relations) {
    if (!takes_target(relation.kind) || relation.targets.size() != 1 ||
        relation.targets.front().center() != target)
      continue;
    switch (relation.kind) {
      case RelationKind::in_front_of:
        keep_only(beside.sides, {0});
        break;
      case RelationKind::behind:
        keep_only(beside.sides, {1});
        break;
      case RelationKind::left_of:
        keep_only(beside.sides, {2});
        break;
      case RelationKind::right_of:
        keep_only(beside.sides, {3});
        break;
      case RelationKind::side_of:
        keep_only(beside.sides, {2, 3});
        break;
      case RelationKind::face_same_as:
        keep_only(beside.turns, {0});
        break;
      case RelationKind::face_opposite_to:
        keep_only(beside.turns, {2});
        break;
      case RelationKind::face_to:
      case RelationKind::used_facing:
        beside.faces_target = true;
        beside.quarters = static_cast<int>(std::lround(relation.turn / (pi / 2)));
        break;
      default:
        break;
    }
  }
  const Vec3& size = context.task.object.size;
  if (!context.task.object.traits.front && !wants(context, RelationKind::edge))
    keep_only(beside.turns, size.x() == size.y() ? std::initializer_list<int>{0}
                                                 : std::initializer_list<int>{0, 1});
  return beside;
}

// Beside the sides of the target that the relations allow, at several gaps, centred or flush with
// its ends, each way round.
void propose_beside(const ProposalContext& context, const ResolvedRelation& relation,
                    const Footprint& target, std::vector<Pose>& poses) {
  const Vec2 size = size_of(context);
  const auto gaps = useful_gaps(context, relation);
  const Beside beside = beside_target(context, target.center());
  constexpr int turn_to_face[4] = {2, 0, 3, 1};  // from the front, back, left, right
  for (int side = 0; side < 4; ++side)
    for (int turn = 0; turn < 4; ++turn) {
      if (!beside.sides[side] || !beside.turns[turn]) continue;
      if (beside.faces_target && turn != (turn_to_face[side] - beside.quarters + 4) % 4) continue;
      const double yaw = wrap_angle(target.yaw() + turn * pi / 2);
      const Vec2 half = turned_half(size, turn * pi / 2);
      const int axis = side < 2 ? 1 : 0;
      const double sign = side == 0 || side == 3 ? -1.0 : 1.0;
      const double slide = target.half()[1 - axis] - half[1 - axis];
      for (double gap : gaps)
        for (double offset : {0.0, slide, -slide, 0.5 * slide, -0.5 * slide}) {
          Vec2 local;
          local[axis] = sign * (target.half()[axis] + gap + half[axis]);
          local[1 - axis] = offset;
          poses.push_back({target.to_world(local), mounting_height(context), yaw});
        }
    }
}

// Seats at the places of a table, for those that will come and for fewer, all looking at it.
void propose_seats(const ProposalContext& context, const ResolvedRelation& relation,
                   const Footprint& target, std::vector<Pose>& poses) {
  constexpr double farthest = 0.5, apart_at_least = 0.02;
  constexpr int usual_at_side = 4;
  const Vec2 size = size_of(context);
  const auto gaps = useful_gaps(context, relation);
  const auto seat = [&](const Vec2& outward, const Vec2& rim) {
    for (double gap : gaps)
      if (gap <= farthest)
        poses.push_back(
            {rim + (gap + 0.5 * size.y()) * outward, mounting_height(context), yaw_facing(-outward)});
  };
  if (target.round()) {
    const int directions = 4 * std::max(context.around_count, 2);
    for (int i = 0; i < directions; ++i) {
      const Vec2 direction = rotated({1, 0}, target.yaw() + 2 * pi * i / directions);
      seat(direction, target.center() + target.half().minCoeff() * direction);
    }
    return;
  }
  const int most = std::max(usual_at_side, (context.around_count + 1) / 2);
  for (int side = 0; side < 4; ++side) {
    const double length = 2 * target.half()[side < 2 ? 0 : 1];
    for (int count = 1; count <= most; ++count) {
      if (count > 1 && length / count < size.x() + apart_at_least) break;
      for (const auto& place :
           composition::seat_places_at_side(target, static_cast<Side>(side), count))
        seat(place.outward, place.rim);
    }
  }
}

// At several distances straight before the target, looking at it, and slantwise.
void propose_facing(const ProposalContext& context, double turn, const Footprint& target,
                    std::vector<Pose>& poses) {
  constexpr int directions = 16;
  const double reach = 0.5 * size_of(context).y();
  // From a step away to across a room, coarser the farther.
  for (double distance : {0.4, 0.8, 1.2, 1.8, 2.4, 3.0})
    for (int i = 0; i < directions; ++i) {
      const Vec2 direction = rotated({1, 0}, target.yaw() + 2 * pi * i / directions);
      const double rim =
          std::abs(direction.dot(target.to_world({1, 0}) - target.center())) * target.half().x() +
          std::abs(direction.dot(target.to_world({0, 1}) - target.center())) * target.half().y();
      poses.push_back({target.center() + (rim + distance + reach) * direction,
                       mounting_height(context), wrap_angle(yaw_facing(-direction) - turn)});
    }
}

// Along the line between the two and a little aside of it, each way round, along the line and along the walls.
void propose_between(const ProposalContext& context, const Footprint& a, const Footprint& b,
                     std::vector<Pose>& poses) {
  const Vec2 line = b.center() - a.center();
  if (line.norm() < 1e-9) return;
  const Vec2 along = line.normalized(), across = left_of(along);
  const double low = reach_along(a, along), high = line.norm() - reach_along(b, along);
  const double aside = std::max(reach_along(a, across), reach_along(b, across));
  for (double share : {0.5, 0.35, 0.65, 0.2, 0.8})
    for (double off : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      const Vec2 at = a.center() + (low + share * (high - low)) * along + off * aside * across;
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({at, mounting_height(context),
                         wrap_angle(yaw_facing(across) + turn * pi / 2)});
      if (!context.surroundings) continue;  // nobody would prefer one that is parallel to the walls
      for (double yaw : context.layout.wall_yaws()) poses.push_back({at, mounting_height(context), yaw});
    }
}

// Furniture on a rug.
void propose_standing_on(const ProposalContext& context, const Footprint& target,
                         std::vector<Pose>& poses) {
  for (double x : {-0.6, -0.3, 0.0, 0.3, 0.6})
    for (double y : {-0.6, -0.3, 0.0, 0.3, 0.6})
      for (int turn = 0; turn < 4; ++turn)
        poses.push_back({target.to_world(Vec2(x, y).cwiseProduct(target.half())),
                         mounting_height(context), wrap_angle(target.yaw() + turn * pi / 2)});
}

void propose_for_relation(const ProposalContext& context, const ResolvedRelation& relation,
                          const Footprint& target, std::vector<Pose>& poses) {
  switch (relation.kind) {
    case RelationKind::around:
      propose_seats(context, relation, target, poses);
      break;
    case RelationKind::face_to:
    case RelationKind::used_facing:
      propose_facing(context, relation.turn, target, poses);
      break;
    case RelationKind::between:
      if (relation.other) propose_between(context, target, *relation.other, poses);
      break;
    case RelationKind::on:
      propose_standing_on(context, target, poses);
      break;
    case RelationKind::under:
    case RelationKind::above:
      for (double turn : {0.0, pi / 2})
        poses.push_back({target.center(), mounting_height(context), target.yaw() + turn});
      break;
    default:
      break;
  }
}

}  // namespace

void propose_for_relations(const ProposalContext& context, std::vector<Pose>& poses) {
  std::vector<Vec2> seen;  // one round of poses beside a target serves all relations with it
  for (const auto& relation : context.relations) {
    if (!takes_target(relation.kind)) continue;
    for (const auto& target : relation.targets) {
      propose_for_relation(context, relation, target, poses);
      if (!definition(relation.kind).has(RelationDefinition::beside) ||
          std::find(seen.begin(), seen.end(), target.center()) != seen.end())
        continue;
      seen.push_back(target.center());
      propose_beside(context, relation, target, poses);
    }
  }
}

}  // namespace roomgen
