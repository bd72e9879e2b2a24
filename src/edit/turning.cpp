#include <algorithm>
#include <cmath>

#include "grouping.h"
#include "operations.h"
#include "placing.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

constexpr double slack_of_turn = 0.5;  // metres that a thing may give way when it turns

// Things of the room or parts of it: where the middle of one is, seen from a thing.
Result<Footprint> target_of(const Draft& draft, const Object& object, const std::string& target) {
  Object asking = object;
  asking.relations = {{RelationKind::face_to, target}};
  if (auto status = check_targets(draft, object.room, asking.relations); !status) return status.error();
  std::vector<Object> others;
  for (const auto& other : draft.scene.objects)
    if (other.room == object.room && other.id != object.id) others.push_back(other);
  const auto resolved = resolve(asking, room_of(draft.scene, object), others, draft.shop.kinds());
  if (resolved.empty() || resolved.front().targets.empty()) return cannot("nothing can face \"" + target + "\"");
  return resolved.front().targets.front();
}

bool looks_at(const Object& object, double direction, const Footprint& target) {
  return ray_hit(target, object.position.head<2>(), front_direction(direction)) >= 0.0;
}

// Square to a wall where that looks at the target too, the least turn first; else straight at its middle.
// `look`: from its front to where its user looks.
std::vector<double> yaws_towards(Draft& draft, const Cluster& cluster, double look,
                                 const Footprint& target) {
  const Object& object = cluster.root;
  std::vector<double> yaws;
  for (const double yaw : draft.layout_without(cluster).wall_yaws())
    if (looks_at(object, yaw + look, target)) yaws.push_back(yaw);
  const auto turn = [&](double yaw) { return std::abs(wrap_angle(yaw - object.yaw)); };
  std::sort(yaws.begin(), yaws.end(), [&](double a, double b) { return turn(a) < turn(b); });
  yaws.push_back(yaw_facing(target.center() - Vec2(object.position.head<2>())) - look);
  return yaws;
}

Status turn_to(Draft& draft, const Object& object, double yaw) {
  const Cluster cluster = whole_of(draft.scene, object);
  Pose pose = pose_of(object);
  pose.yaw = wrap_angle(yaw);
  auto turned = there_or_near(draft, cluster, pose, slack_of_turn);
  if (!turned) return turned.error();
  turned->root.relations = object.relations;
  draft.put(*turned);
  if (object.traits.flat) settle_heights(draft, object.room);
  return {};
}

}  // namespace

Status carry_out(Draft& draft, const edit::Turn& turn) {
  const auto object = object_to_change(draft, turn.object);
  if (!object) return object.error();
  if (!turn.group) return turn_to(draft, *object, object->yaw + turn.by);
  Pose pose = pose_of(*object);
  pose.yaw = wrap_angle(pose.yaw + turn.by);
  return move_group_to(draft, *object, pose);
}

Status carry_out(Draft& draft, const edit::Face& face) {
  const auto object = object_to_change(draft, face.object);
  if (!object) return object.error();
  if (!object->traits.front) return cannot(object->id + " has no front that could face anything");
  if (object->mount == Mount::wall) return cannot(object->id + " hangs on a wall and cannot be turned");
  const auto target = target_of(draft, *object, face.target);
  if (!target) return target.error();
  const Kind& kind = draft.shop.kinds().get(object->category);
  const std::vector<Relation> asked = {{facing_of_use(kind), face.target}};
  Status why;
  for (const double yaw :
       yaws_towards(draft, whole_of(draft.scene, *object), turn_of(kind.faces), *target)) {
    Draft trial = draft;
    auto status = turn_to(trial, *object, yaw);
    if (status &&
        !lost_relations(*find_object(trial.scene, object->id), asked, trial.scene, draft.shop.kinds()).empty())
      status = cannot("where there is room for it, " + object->id + " does not face " + face.target);
    if (status) {
      draft.take_over(std::move(trial));
      wish_relations(draft, *object, asked);
      return {};
    }
    if (why) why = status;
  }
  return why;
}

}  // namespace roomgen
