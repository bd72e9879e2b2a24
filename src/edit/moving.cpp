#include <algorithm>

#include "grouping.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

constexpr double shift_step = 0.05;  // metres, in which it is found how far a shift could go
constexpr double same_spot = 0.05;   // metres; where things stand on others, places are 2 cm apart

// What says where a thing stands among others; facing and walls are another matter.
bool is_about_place(RelationKind kind) {
  switch (kind) {
    case RelationKind::edge:
    case RelationKind::face_to:
    case RelationKind::used_facing:
    case RelationKind::face_same_as:
    case RelationKind::face_opposite_to:
    case RelationKind::hang_from:
      return false;
    default:
      return true;
  }
}

bool says_support(const std::vector<Relation>& relations) {
  return std::any_of(relations.begin(), relations.end(), [](const Relation& one) {
    return one.kind == RelationKind::on || one.kind == RelationKind::inside;
  });
}

// Of its own relations those that the new place leaves open.
std::vector<Relation> still_wanted(const Object& object, const std::vector<Relation>& asked) {
  std::vector<Relation> kept;
  for (const auto& relation : object.relations) {
    const bool is_said = std::find(asked.begin(), asked.end(), relation) != asked.end();
    if (!is_said && !is_about_place(relation.kind)) kept.push_back(relation);
  }
  return kept;
}

// How far of the way it could go, in steps; 0 if not at all.
double possible_share(Draft& draft, const Cluster& cluster, const Vec2& by) {
  for (double left = by.norm() - shift_step; left > 0.5 * shift_step; left -= shift_step) {
    Pose pose = pose_of(cluster.root);
    pose.position += by * (left / by.norm());
    if (exactly_at(draft, cluster, pose, RugEdges::stood_on)) return left;
  }
  return 0.0;
}

// Only what hangs may be higher or lower.
Status raise(Draft& draft, const Object& object, const Vec3& by) {
  if (object.mount != Mount::wall && object.mount != Mount::ceiling)
    return cannot(object.id + " stands on something and cannot hang in the air");
  Pose pose = pose_of(object);
  pose.position += by.head<2>();
  pose.bottom += by.z();
  if (pose.bottom < 0.0) return cannot(object.id + " would be below the floor");
  const auto there = exactly_at(draft, whole_of(draft.scene, object), pose);
  if (!there) return there.error();
  draft.put(*there);
  return {};
}

// What carries a thing there: what does by now if it reaches so far, else the highest that is
// there.
std::string carrier_at(const Scene& scene, const Object& object, const Vec2& position) {
  const Object* best = nullptr;
  for (const auto& one : scene.objects) {
    const bool is_over = one.id == object.id || one.on == object.id || one.mount == Mount::ceiling;
    if (is_over || one.traits.flat || one.room != object.room ||
        !contains(footprint(one), position))
      continue;
    if (one.id == object.on) return one.id;
    if (!best || top(one) > top(*best)) best = &one;
  }
  return best ? best->id : object.on;
}

// What hangs from a thing is under it also elsewhere.
Status check_hook(const Draft& draft, const Object& object) {
  const Object* hook = hook_of(draft.scene, object.relations);
  if (!hook || top(object) > room_of(draft.scene, object).height - same_spot ||
      lost_relations(object, {{RelationKind::hang_from, hook->id}}, draft.scene, draft.shop.kinds())
          .empty())
    return {};
  return cannot(object.id + " hangs from " + hook->id + ", which is not over that place");
}

// The room that is said, or the one of what it is to stand to.
Result<std::string> room_to_go_to(const Draft& draft, const edit::Move& move, const Object& object) {
  if (!move.room.empty()) return room_named(draft, move.room);
  for (const auto& relation : move.relations)
    if (const Object* target = find_object(draft.scene, relation.target)) return target->room;
  return object.room;
}

Status check_move(const Draft& draft, const Object& object, const std::string& room,
                  const std::vector<Relation>& relations) {
  if (auto status = check_targets(draft, room, relations); !status) return status;
  for (const auto& relation : relations)
    if (relation.target == object.id) return cannot(object.id + " cannot stand beside itself");
  if (says_support(relations) && object.mount != Mount::surface)
    return cannot(object.id + " does not stand on other things");
  return {};
}

}  // namespace

Status carry_out(Draft& draft, const edit::Move& move) {
  auto object = object_to_change(draft, move.object);
  if (!object) return object.error();
  const auto group = move.group ? group_of(draft.scene, *object) : std::vector<Cluster>();
  const auto room = room_to_go_to(draft, move, *object);
  if (!room) return room.error();
  if (auto status = check_move(draft, *object, *room, move.relations); !status) return status;
  auto raised = hung(draft, in_room(whole_of(draft.scene, *object), *room), move.relations);
  if (!raised) return raised.error();
  Cluster& cluster = *raised;
  Aim aim;
  aim.asked = move.relations;
  if (*room == object->room) aim.kept = still_wanted(*object, move.relations);
  else cluster.root.relations.clear();
  aim.usual = true;
  Draft alone = draft;
  alone.take_out(ids_of(group));
  if (auto status = place_or_make_way(move.group ? alone : draft, cluster, aim); !status) return status;
  if (move.group)
    if (auto status = take_group_along(draft, alone, group, *find_object(alone.scene, object->id)); !status)
      return status;
  wish_relations(draft, cluster.root, move.relations);
  for (const auto& changed : {object->room, *room})
    if (object->traits.flat) settle_heights(draft, changed);
  return {};
}

Status carry_out(Draft& draft, const edit::Put& put) {
  const auto object = object_to_change(draft, put.object);
  if (!object) return object.error();
  Cluster cluster = whole_of(draft.scene, *object);
  Pose pose{put.position, object->position.z(), put.yaw.value_or(object->yaw)};
  if (object->mount == Mount::surface) {
    cluster.root.on = put.on.empty() ? carrier_at(draft.scene, *object, put.position) : put.on;
    if (auto carrier = object_named(draft, cluster.root.on); !carrier) return carrier.error();
    Aim aim;
    aim.near_to = pose;
    aim.most_off = same_spot;
    auto there = find_place(draft, draft.layout_without(cluster), cluster, aim);
    if (!there) return there.error();
    there->root.relations = object->relations;
    return draft.put(*there), Status();
  }
  auto there = exactly_at(draft, cluster, pose);
  if (!there) there = exactly_at(draft, cluster, pose, RugEdges::stood_on);
  if (!there) return there.error();
  if (auto status = check_hook(draft, there->root); !status) return status;
  draft.put(*there);
  if (object->traits.flat) settle_heights(draft, object->room);
  return {};
}

Status carry_out(Draft& draft, const edit::Shift& shift) {
  const auto object = object_to_change(draft, shift.object);
  if (!object) return object.error();
  const Vec2 by = shift.by.head<2>();
  if (shift.by.z() != 0.0) return raise(draft, *object, shift.by);
  if (shift.group) {
    Pose pose = pose_of(*object);
    pose.position += by;
    return move_group_to(draft, *object, pose);
  }
  edit::Put put{object->id, Vec2(object->position.head<2>()) + by, object->yaw, object->on};
  auto status = carry_out(draft, put);
  if (status || object->mount == Mount::surface) return status;
  const double possible = possible_share(draft, whole_of(draft.scene, *object), by);
  return cannot(status.error().message +
                (possible > 0.0 ? "; " + format_number(possible, 2) + " m that way would be possible" : ""));
}

}  // namespace roomgen
