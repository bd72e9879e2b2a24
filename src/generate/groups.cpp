#include <algorithm>

#include "attempts.h"
#include "consult.h"
#include "fits_as_it_is.h"
#include "prepare.h"
#include "retrieve.h"
#include "scene/resolved_relation.h"
#include "solve/place_group.h"

namespace roomgen {

using composition::Member;

std::string Cast::id_of(const Member& member) const {
  const auto found = ids.find({member.part, member.number});
  return found == ids.end() ? std::string() : found->second;
}

const Object* Cast::object_of(const Member& member) const {
  const auto found = things.find(id_of(member));
  return found == things.end() ? nullptr : &found->second.task.object;
}

namespace {

// In a scene each of the groups within a group is one of its own: a table moves with its chairs,
// not with all tables. What is in none of them goes with the anchor.
std::string name_in_scene(const Work& work, composition::Role role) {
  for (const auto& [id, other] : work.place.roles.by_id())
    if (role.unit < 0 && other.is_anchor && other.group == role.group) role.unit = other.unit;
  return role.unit < 0 ? role.group : role.group + "#" + std::to_string(role.unit);
}

// With its anchor. Those that stand already, or that nothing is found for, are none of it.
Cast cast_of(Work& work, const PlacementTask& anchor, const std::string& group) {
  Cast cast;
  cast.things[anchor.object.id].task = anchor;
  for (const auto& planned : planned_objects(work.place.plan)) {
    const auto* role = work.role_of(planned.id);
    if (!role || role->group != group || work.layout().find(planned.id) ||
        !work.item(planned).left_out.empty())
      continue;
    cast.ids[{role->part, role->number}] = planned.id;
    if (planned.id == anchor.object.id) continue;
    auto asset = asset_for(work, planned);
    if (!asset) continue;
    auto task = prepare(work, planned, *asset);
    if (!task) continue;
    remember(work.state.favourites, work.item(planned), *asset);
    task->object.group = name_in_scene(work, *role);
    cast.things[planned.id] = {*std::move(asset), *std::move(task)};
  }
  return cast;
}

// Where a member goes, as the word of a designer.
PlaceAdvice place_in_frame(const Work& work, const StandingGroup& group,
                           const StandingGroup::Post& post, const Object& object) {
  const Object& anchor = group.anchor.object;
  const auto at = composition::within({anchor.position.head<2>(), anchor.yaw}, post.place);
  PlaceAdvice given;
  given.relations =
      known_relations(object.relations, work.layout().room(), work.layout().objects());
  if (!post.carrier.empty()) given.relations.push_back({RelationKind::on, post.carrier});
  given.location = at.position;
  given.yaw = at.yaw;
  given.spread = post.spread;
  return given;
}

// A member at its place in the frame, if it is one of those that were placed with the anchor.
bool stand_in_frame(Work& work, const StandingGroup& group, const PlacementTask& task) {
  for (auto& object : companions_of(group.anchor, group.anchor.object)) {
    if (object.id != task.object.id) continue;
    object.relations = task.object.relations;
    object.locked = true;
    if (!fits_as_it_is(work.layout(), object, group.even_useless)) return false;
    work.layout().add(std::move(object));
    return true;
  }
  return false;
}

// At its place, or as near to it as there is room: on what carries it, or about there.
bool stand(Work& work, const StandingGroup& group, const PlannedObject& planned, Attempt& attempt) {
  constexpr double about = 0.5;
  const auto& post = group.posts.at(planned.id);
  auto [asset, task] = group.cast->things.at(planned.id);
  task.object.locked = true;
  if (!post.carrier.empty()) {
    if (!work.layout().find(post.carrier)) return false;
    auto tried = try_to_place(work, planned, asset, attempt.answer, post.refused, task);
    if (tried) attempt = *std::move(tried);
    return tried && attempt.refused.empty();
  }
  if (!follow(work, attempt.answer, planned, 0, task)) return false;
  if (!stand_in_frame(work, group, task)) {
    PlaceOptions options = work.place_options();
    options.accepts = [&](const Pose& pose) {
      return (pose.position - *task.location).norm() <= about;
    };
    auto placed = place(work.layout(), task, {}, options, work.state.random);
    if (!placed) return false;
    work.layout().add(std::move(placed->object));
  }
  enter(work, planned, asset, std::move(task));
  return true;
}

StandingGroup* standing_group(const Work& work, const std::string& id) {
  for (auto& group : work.state.groups)
    if (group.posts.count(id) > 0) return &group;
  return nullptr;
}

// Not only some of the groups within it.
bool whole_group_stands(const Work& work, const PlannedObject& planned) {
  const auto* role = work.role_of(planned.id);
  return role && std::any_of(work.state.groups.begin(), work.state.groups.end(),
                             [&](const StandingGroup& group) {
                               return group.id == role->group && group.is_whole;
                             });
}

// What stands about the anchor in a way of the group.
std::vector<PlacementTask::Companion> companions_in(const Work& work,
                                                    const composition::Arranged& way,
                                                    const Cast& cast) {
  std::vector<std::size_t> members;
  return companions(
      way, [&](const Member& member) { return cast.object_of(member); }, work.place.room, members);
}

// The things of the group whose meshes overlap those before them, wherever it stands.
std::set<std::string> overlapping(Work& work, const composition::Arranged& way, const Cast& cast) {
  PlacementTask task;
  task.object = *cast.object_of(way.members.front());
  task.companions = companions_in(work, way, cast);
  std::vector<Object> apart = {task.object};
  std::set<std::string> found;
  for (auto& object : companions_of(task, task.object)) {
    const bool overlaps = std::any_of(apart.begin(), apart.end(), [&](const Object& other) {
      return work.layout().solids().overlap(object, other);
    });
    if (overlaps) found.insert(object.id);
    else apart.push_back(std::move(object));
  }
  return found;
}

// Seats are drawn up to their table as far as the meshes allow.
Result<std::vector<composition::Arranged>> ways_that_hold_together(
    Work& work, const PlanGroup& group, const Cast& cast, const composition::SizeOf& size_of) {
  const auto ways = [&](double tuck) {
    return composition::ways_to_stand(work.place.plan, group, work.place.categories,
                                      {size_of, tuck});
  };
  for (const double tuck : {1.0, 0.5})
    if (auto drawn = ways(tuck); !drawn || overlapping(work, drawn->front(), cast).empty())
      return drawn;
  return ways(0.0);
}

Result<std::vector<composition::Arranged>> ways_of(Work& work, const PlannedObject& anchor,
                                                   const Cast& cast) {
  if (const auto unit = work.state.units.find(anchor.id); unit != work.state.units.end())
    return std::vector<composition::Arranged>{unit->second};
  const auto size_of = [&](const std::string& part) -> std::optional<Vec3> {
    const auto found = cast.ids.find({part, 0});
    const auto known =
        found == cast.ids.end() ? cast.things.end() : cast.things.find(found->second);
    return known == cast.things.end() ? std::nullopt
                                      : std::optional<Vec3>(known->second.task.object.size);
  };
  return ways_that_hold_together(work, *composition::find_group(work.place.plan, work.role_of(anchor.id)->group), cast,
                                 size_of);
}

// What lost its place in a group finds one for itself behind all that has one by the plan.
void let_wait(Work& work, const std::function<bool(const PlannedObject&)>& is_dropped) {
  auto& left = work.state.left;
  const auto last = std::find_if(left.rbegin(), left.rend(), [&](const PlannedObject& planned) {
    return work.role_of(planned.id) || work.item(planned).location;
  });
  composition::postpone(work.place.plan, {left.begin(), last.base()}, is_dropped);
}

}  // namespace

// By the prompt, or by who made the group.
static bool is_wanted(const Work& work, const PlannedObject& planned) {
  const PlanItem& item = work.item(planned);
  const PlanGroup* group = composition::find_group(work.place.plan, item.group);
  return item.asked || (group && group->asked && item.spare == 0);
}

bool begins_group(const Work& work, const PlannedObject& planned) {
  if (work.state.units.count(planned.id)) return true;
  const auto* role = work.role_of(planned.id);
  return role && role->is_anchor && !work.state.tried_groups.count(role->group);
}

Result<Placement> place_with_group(Work& work, const PlannedObject& planned, PlacementTask& task,
                                   const PlaceOptions& options) {
  const std::string& id = work.role_of(planned.id)->group;
  task.object.group = name_in_scene(work, *work.role_of(planned.id));
  Cast cast = cast_of(work, task, id);
  auto ways = ways_of(work, planned, cast);
  if (!ways) return ways.error();
  const bool is_whole = work.state.units.count(planned.id) == 0;
  PlacementTask whole = task;
  if (is_whole) whole.composition = composition::find_group(work.place.plan, id)->composition;
  // What has no room in the group itself shall not cost it its place.
  const auto loose = overlapping(work, ways->front(), cast);
  const auto thing_of = [&](const Member& member) {
    return loose.count(cast.id_of(member)) > 0 ? nullptr : cast.object_of(member);
  };
  auto placed = place_group(work.layout(), whole, {*ways, thing_of}, options, work.state.random);
  if (!placed) return placed.error();
  StandingGroup standing{id, is_whole, {}, std::move(placed->task), {}, options.even_useless};
  const auto& members = (*ways)[placed->way].members;
  for (const auto& member : members) {
    const bool is_carried = member.mount == Mount::surface;
    const std::string carrier = is_carried ? cast.id_of(members[member.on]) : std::string();
    if (cast.object_of(member) && is_carried == !carrier.empty())
      standing.posts[cast.id_of(member)] = {member.place, carrier, member.spread};
  }
  standing.anchor.object = placed->placement.object;
  standing.cast = std::make_shared<const Cast>(std::move(cast));
  work.state.groups.push_back(std::move(standing));
  if (is_whole)
    let_wait(work, [&](const PlannedObject& other) {
      const auto* role = work.role_of(other.id);
      return role && role->group == id && !standing_group(work, other.id);
    });
  work.state.tried_groups.insert(id);
  task.object.locked = placed->placement.object.locked = true;
  return std::move(placed->placement);
}

void disband(Work& work, const std::string& anchor) {
  auto& groups = work.state.groups;
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const StandingGroup& group) {
    return group.anchor.object.id == anchor;
  });
  if (found == groups.end()) return;
  if (found->is_whole) work.state.tried_groups.erase(found->id);
  groups.erase(found);
}

PlacementTask with_companions(Work& work, const PlannedObject& planned, const PlacementTask& task) {
  PlacementTask whole = task;
  if (!begins_group(work, planned)) return whole;
  const Cast cast = cast_of(work, task, work.role_of(planned.id)->group);
  if (const auto ways = ways_of(work, planned, cast); ways && !ways->empty())
    whole.companions = companions_in(work, ways->front(), cast);
  return whole;
}

void fall_apart(Work& work, const PlannedObject& planned, const PlacementTask& task) {
  const auto& own = *work.role_of(planned.id);
  const bool is_unit = work.state.units.erase(planned.id) > 0;
  if (!is_unit) {
    work.state.tried_groups.insert(own.group);
    const Cast cast = cast_of(work, task, own.group);
    const auto ways = ways_of(work, planned, cast);
    if (!ways) return;
    for (auto& unit : composition::units_of(ways->front())) {
      const std::string anchor = cast.id_of(unit.members.front());
      if (unit.members.size() > 1 && !anchor.empty())
        work.state.units.emplace(anchor, std::move(unit));
    }
  }
  let_wait(work, [&](const PlannedObject& other) {
    const auto* role = work.role_of(other.id);
    return role && role->group == own.group && (is_unit ? role->unit == own.unit : role->unit < 0);
  });
}

bool take_place_in_group(Work& work, const PlannedObject& planned, Step& step) {
  StandingGroup* group = standing_group(work, planned.id);
  const bool must_stand = is_wanted(work, planned);
  if (!group) {
    const bool has_no_room = !must_stand && whole_group_stands(work, planned);
    if (has_no_room) step.reason = "its group had no room for it";
    return has_no_room;
  }
  if (group->anchor.object.id == planned.id) return false;
  auto& post = group->posts.at(planned.id);
  const auto& [asset, task] = group->cast->things.at(planned.id);
  Attempt attempt = begun(asset, place_in_frame(work, *group, post, task.object));
  const bool stands = stand(work, *group, planned, attempt);
  step.has_assets = true;
  if (!stands && attempt.refused.empty()) attempt.refused = "its place in its group is taken";
  step.attempts.push_back(std::move(attempt));
  if (stands) return true;
  const std::string why = "there was no room for it where its group has it";
  if (!must_stand) return step.reason = why, true;
  if (post.refused++ > 0) return false;
  auto& left = work.state.left;
  left.insert(left.begin(), planned);
  let_wait(work, [&](const PlannedObject& other) { return other.id == planned.id; });
  if (left.front().id != planned.id) return step.reason = why + ": it waits for others", true;
  take_up(work.state, planned.id);
  return take_place_in_group(work, planned, step);
}

}  // namespace roomgen
