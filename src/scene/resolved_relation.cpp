#include "resolved_relation.h"

#include <algorithm>
#include <utility>

#include "scene/room_part.h"

namespace roomgen {

namespace {

std::vector<Footprint> corners(const Room& room) {
  std::vector<Footprint> result;
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (room.polygon.is_convex_corner(k))
      result.emplace_back(room.polygon.points[k], Vec2(part_depth, part_depth), 0.0);
  return result;
}

std::vector<Footprint> walls(const Room& room) {
  std::vector<Footprint> result;
  for (const auto& name : wall_names(room)) result.push_back(*part_of_room(room, name));
  return result;
}

AlignAxis align_axis(const Object& object, const std::string& target) {
  for (const auto& relation : object.relations) {
    if (relation.target != target) continue;
    switch (relation.kind) {
      case RelationKind::in_front_of:
      case RelationKind::behind:
        return AlignAxis::lateral;
      case RelationKind::left_of:
      case RelationKind::right_of:
      case RelationKind::side_of:
        return AlignAxis::longitudinal;
      default:
        break;
    }
  }
  return AlignAxis::either;
}

// What is near a thing and not at a side of it leaves a gap: who means "beside" says so.
constexpr double near_gap_low = 0.25;
constexpr double near_gap_high = 0.7;

bool is_merely_near(const Object& object, const Relation& relation) {
  if (relation.kind != RelationKind::near) return false;
  return std::none_of(object.relations.begin(), object.relations.end(), [&](const Relation& other) {
    return other.target == relation.target && other.kind != RelationKind::near &&
           !is_looking_at(other.kind);
  });
}

bool is_at_side(RelationKind kind) {
  return kind == RelationKind::left_of || kind == RelationKind::right_of || kind == RelationKind::side_of;
}

// What is at a side of an opening, or of what hangs on a wall, has its centre no farther before it: that has no depth to
// be judged by, and a bed with its head at the wall is 2.1 m long.
constexpr double beside_opening = 1.2;

std::vector<Footprint> targets_of(const Relation& relation, const Room& room,
                                  std::span<const Object> placed) {
  if (!takes_target(relation.kind)) return {Footprint()};
  if (relation.target == "corner") return corners(room);
  if (relation.target == nearest_wall) return walls(room);
  if (const auto part = part_of_room(room, relation.target)) {
    if (!is_at_side(relation.kind)) return {*part};
    return {Footprint(part->center(), {2.0 * part->half().x(), 2.0 * beside_opening}, part->yaw())};
  }
  if (const auto region = region_of_room(room, relation.target)) return {*region};
  if (const Object* target = find_object(placed, relation.target)) {
    if (target->mount != Mount::wall || !is_at_side(relation.kind)) return {footprint(*target)};
    return {Footprint(target->position.head<2>(), {target->size.x(), 2.0 * beside_opening}, target->yaw)};
  }
  return {};
}

bool is_wall(const Relation& relation, std::span<const Object> placed) {
  return relation.target.starts_with("wall") && !find_object(placed, relation.target);
}

// What hangs on a wall is near that wall, not near one round the corner.
bool means_wall_at_back(const Object& object, const Relation& relation,
                        std::span<const Object> placed) {
  const bool is_near =
      relation.kind == RelationKind::near || relation.kind == RelationKind::next_to;
  return is_wall(relation, placed) &&
         (relation.kind == RelationKind::hang_from || (is_near && object.mount == Mount::wall));
}

// Of what is between two: that with which the relation is said the other time.
std::optional<Footprint> other_end(const Object& object, const Relation& relation,
                                   const Room& room, std::span<const Object> placed) {
  for (const auto& other : object.relations) {
    if (other.kind != RelationKind::between || other.target == relation.target) continue;
    const auto targets = targets_of(other, room, placed);
    if (!targets.empty()) return targets.front();
  }
  return std::nullopt;
}

// The range that either of the two prefers for the other.
void set_preferred_gap(ResolvedRelation& resolved, const Kind& own, const Kind& other) {
  for (const auto* pair : {&own, &other}) {
    const Kind& partner = pair == &own ? other : own;
    for (const auto& preferred : pair->gaps)
      if (is_of(partner, preferred.partner)) {
        resolved.gap_low = preferred.low;
        resolved.gap_high = preferred.high;
        return;
      }
  }
}

// How far it shall be from a target: "2 m in front of it" is tried there.
const Gap* gap_told(const Object& object, const std::string& target) {
  const auto told = std::find_if(object.relations.begin(), object.relations.end(), [&](const Relation& one) {
    return one.kind == RelationKind::gap && one.target == target;
  });
  return told == object.relations.end() ? nullptr : &told->gap;
}

}  // namespace

std::vector<ResolvedRelation> resolve(const Object& object, const Room& room,
                                      std::span<const Object> placed,
                                      const KindTable& categories) {
  std::vector<ResolvedRelation> result;
  const Kind& own = categories.get(object.category);
  for (const auto& relation : object.relations) {
    ResolvedRelation resolved;
    resolved.kind = relation.kind;
    resolved.target_top = room.height;
    resolved.axis = align_axis(object, relation.target);
    if (is_merely_near(object, relation)) {
      resolved.gap_low = near_gap_low;
      resolved.gap_high = near_gap_high;
    }
    if (relation.kind == RelationKind::used_facing) resolved.turn = turn_of(own.faces);
    resolved.targets = targets_of(relation, room, placed);
    resolved.is_of_nearest_wall = relation.target == nearest_wall;
    resolved.stands = object.mount == Mount::floor || object.mount == Mount::surface;
    resolved.at_back = means_wall_at_back(object, relation, placed);
    if (relation.kind == RelationKind::between)
      resolved.other = other_end(object, relation, room, placed);
    if (const Object* target = find_object(placed, relation.target)) {
      resolved.target_bottom = bottom(*target);
      resolved.target_top = top(*target);
      set_preferred_gap(resolved, own, categories.get(target->category));
      // What hangs is "on the line" as it hangs from it.
      if (relation.kind == RelationKind::on && object.mount == Mount::ceiling)
        resolved.kind = RelationKind::hang_from;
    }
    if (const auto gap = gap_told(object, relation.target)) resolved.gap_low = gap->least, resolved.gap_high = gap->most;
    result.push_back(std::move(resolved));
  }
  return result;
}

RelationKind facing_of_use(const Kind& kind) {
  return kind.faces == Side::front ? RelationKind::face_to : RelationKind::used_facing;
}

std::vector<Relation> known_relations(const std::vector<Relation>& relations, const Room& room,
                                      std::span<const Object> placed) {
  std::vector<Relation> known;
  for (const auto& relation : relations)
    if (relation.target.empty() || is_part_of_room(room, relation.target) ||
        find_object(placed, relation.target))
      known.push_back(relation);
  return known;
}

}  // namespace roomgen
