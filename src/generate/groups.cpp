#include "groups.h"

#include <algorithm>

#include "attempts.h"
#include "fits_as_it_is.h"
#include "prepare.h"
#include "retrieve.h"
#include "scene/resolved_relation.h"
#include "solve/place_group.h"

namespace roomgen {

namespace {

using composition::Member;

const composition::Role* role_of(const Work& work, const std::string& id) {
  const auto found = work.place.roles.find(id);
  return found == work.place.roles.end() ? nullptr : &found->second;
}

const PlanGroup* group_of(const Work& work, const std::string& id) {
  const auto& groups = work.place.plan.groups;
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const PlanGroup& group) { return group.id == id; });
  return found == groups.end() ? nullptr : &*found;
}

/// The things of a group as they will be: each with an asset, before any stands.
struct Cast {
  std::map<std::pair<std::string, std::size_t>, std::string> ids;  ///< by part and number
  std::map<std::string, PlacementTask> tasks;                      ///< by id

  std::string id_of(const Member& member) const {
    const auto found = ids.find({member.part, member.number});
    return found == ids.end() ? std::string() : found->second;
  }
  const Object* object_of(const Member& member) const {
    const auto found = tasks.find(id_of(member));
    return found == tasks.end() ? nullptr : &found->second.object;
  }
};

// Those that stand already, or that nothing is found for, are none of the cast.
Cast cast_of(Work& work, const std::string& group) {
  Cast cast;
  for (const auto& planned : planned_objects(work.place.plan)) {
    const auto* role = role_of(work, planned.id);
    if (!role || role->group != group || work.layout().find(planned.id)) continue;
    cast.ids[{role->part, role->number}] = planned.id;
    const auto assets = assets_for(work, planned);
    if (!assets || assets->empty()) continue;
    auto task = prepare(work, planned, assets->front());
    if (!task) continue;
    remember(work.state.favourites, work.item(planned), assets->front());
    task->object.group = group;
    cast.tasks.emplace(planned.id, *std::move(task));
  }
  return cast;
}

// What stands on others goes where its place in the frame is, or anywhere on that.
bool stand_on(Work& work, PlacementTask task, const Object& carrier) {
  task.object.mount = Mount::surface;
  task.object.on = carrier.id;
  const Relation on{RelationKind::on, carrier.id};
  if (std::find(task.object.relations.begin(), task.object.relations.end(), on) ==
      task.object.relations.end())
    task.object.relations.push_back(on);
  PlaceOptions options = work.place.options.place;
  options.cancel = work.cancel;
  auto placed = place(work.layout(), task, {}, options, work.state.random);
  if (!placed) {
    task.location.reset(), task.facing.reset();
    task.binding = false;
    placed = place(work.layout(), task, {}, options, work.state.random);
  }
  if (!placed) return false;
  placed->object.locked = true;
  work.layout().add(placed->object);
  return true;
}

// Where a member goes, as the word of a designer.
PlaceAdvice place_in_frame(const Work& work, const StandingGroup& group, std::size_t index,
                           PlacementTask& task) {
  const Object& anchor = group.anchor.object;
  const auto at = composition::within({anchor.position.head<2>(), anchor.yaw},
                                      group.arranged.members[index].place);
  task.object.relations =
      known_relations(task.object.relations, work.layout().room(), work.layout().objects());
  task.location = at.position;
  task.facing = at.yaw;
  task.binding = true;
  PlaceAdvice given;
  given.relations = task.object.relations;
  given.location = at.position;
  given.yaw = at.yaw;
  return given;
}

// A member at its place in the frame, if it is one of those that were placed with the anchor.
bool stand_in_frame(Work& work, const StandingGroup& group, std::size_t index,
                    const PlacementTask& task) {
  const auto companion = std::find(group.companions.begin(), group.companions.end(), index);
  if (companion == group.companions.end()) return false;
  const auto all = companions_of(group.anchor, group.anchor.object);
  Object object = all[static_cast<std::size_t>(companion - group.companions.begin())];
  object.relations = task.object.relations;
  object.locked = true;
  if (!fits_as_it_is(work.layout(), object)) return false;
  work.layout().add(std::move(object));
  return true;
}

bool stand(Work& work, const StandingGroup& group, std::size_t index, const PlacementTask& task) {
  const Member& member = group.arranged.members[index];
  if (member.mount != Mount::surface) return stand_in_frame(work, group, index, task);
  const Object* carrier = work.layout().find(group.ids[member.on]);
  return carrier && stand_on(work, task, *carrier);
}

const StandingGroup* standing_group(const Work& work, const std::string& id) {
  for (const auto& group : work.state.groups)
    if (std::find(group.ids.begin(), group.ids.end(), id) != group.ids.end()) return &group;
  return nullptr;
}

// Not only some of the groups within it.
bool whole_group_stands(const Work& work, const PlannedObject& planned) {
  const auto* role = role_of(work, planned.id);
  return role && std::any_of(work.state.groups.begin(), work.state.groups.end(),
                             [&](const StandingGroup& group) {
                               return group.id == role->group && group.is_whole;
                             });
}

// In a scene each of the groups within a group is one of its own: a table moves with its chairs,
// not with all tables.
std::string name_in_scene(const std::string& id, const PlannedObject& planned, const Work& work) {
  const int unit = role_of(work, planned.id)->unit;
  return unit < 0 ? id : id + "#" + std::to_string(unit);
}

// Whether meshes of the group's own things overlap, wherever it stands.
bool overlaps_itself(Work& work, const composition::Arranged& way, const Cast& cast) {
  const Object* anchor = cast.object_of(way.members.front());
  PlacementTask task;
  std::vector<std::size_t> members;
  task.companions = companions(
      way, [&](const Member& member) { return cast.object_of(member); }, work.place.room, members);
  auto all = companions_of(task, *anchor);
  all.push_back(*anchor);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (work.layout().solids().overlap(all[i], all[j])) return true;
  return false;
}

// Seats are drawn up to their table as far as the meshes allow.
Result<std::vector<composition::Arranged>> ways_that_hold_together(
    Work& work, const PlanGroup& group, const Cast& cast, const composition::SizeOf& size_of) {
  const auto ways = [&](double tuck) {
    return composition::ways_to_stand(work.place.plan, group, work.place.categories,
                                      {size_of, tuck});
  };
  for (const double tuck : {1.0, 0.5})
    if (auto drawn = ways(tuck); !drawn || !overlaps_itself(work, drawn->front(), cast))
      return drawn;
  return ways(0.0);
}

Result<std::vector<composition::Arranged>> ways_of(Work& work, const PlannedObject& anchor,
                                                   const Cast& cast) {
  if (const auto unit = work.state.units.find(anchor.id); unit != work.state.units.end())
    return std::vector<composition::Arranged>{unit->second};
  const auto size_of = [&](const std::string& part) -> std::optional<Vec3> {
    const auto found = cast.ids.find({part, 0});
    const auto known = found == cast.ids.end() ? cast.tasks.end() : cast.tasks.find(found->second);
    return known == cast.tasks.end() ? std::nullopt
                                     : std::optional<Vec3>(known->second.object.size);
  };
  return ways_that_hold_together(work, *group_of(work, role_of(work, anchor.id)->group), cast,
                                 size_of);
}

}  // namespace

bool begins_group(const Work& work, const PlannedObject& planned) {
  if (work.state.units.count(planned.id)) return true;
  const auto* role = role_of(work, planned.id);
  return role && role->is_anchor && !work.state.tried_groups.count(role->group);
}

Result<Placement> place_with_group(Work& work, const PlannedObject& planned, PlacementTask& task) {
  const std::string& id = role_of(work, planned.id)->group;
  Cast cast = cast_of(work, id);
  task.object.group = name_in_scene(id, planned, work);
  cast.tasks[planned.id] = task;
  auto ways = ways_of(work, planned, cast);
  if (!ways) return ways.error();
  const bool is_whole = work.state.units.count(planned.id) == 0;
  PlacementTask whole = task;
  if (is_whole) whole.composition = group_of(work, id)->composition;
  PlaceOptions options = work.place.options.place;
  options.cancel = work.cancel;
  const auto thing_of = [&](const Member& member) { return cast.object_of(member); };
  auto placed = place_group(work.layout(), whole, *ways, thing_of, options, work.state.random);
  if (!placed) return placed.error();
  StandingGroup standing{id, is_whole, std::move((*ways)[placed->way]), {}, placed->task, {}};
  for (const auto& member : standing.arranged.members) standing.ids.push_back(cast.id_of(member));
  standing.anchor.object = placed->placement.object;
  companions(standing.arranged, thing_of, work.place.room, standing.companions);
  work.state.groups.push_back(std::move(standing));
  work.state.tried_groups.insert(id);
  task.object.locked = placed->placement.object.locked = true;
  return std::move(placed->placement);
}

void fall_apart(Work& work, const PlannedObject& planned) {
  if (work.state.units.erase(planned.id) > 0) return;
  const auto* role = role_of(work, planned.id);
  work.state.tried_groups.insert(role->group);
  const Cast cast = cast_of(work, role->group);
  const auto ways = ways_of(work, planned, cast);
  if (!ways) return;
  for (auto& unit : composition::units_of(ways->front())) {
    const std::string anchor = cast.id_of(unit.members.front());
    if (unit.members.size() > 1 && !anchor.empty())
      work.state.units.emplace(anchor, std::move(unit));
  }
}

bool take_place_in_group(Work& work, const PlannedObject& planned, Step& step) {
  const StandingGroup* group = standing_group(work, planned.id);
  const bool must_stand = work.item(planned).asked;
  if (!group) {
    const bool has_no_room = !must_stand && whole_group_stands(work, planned);
    if (has_no_room) step.reason = "its group had no room for it";
    return has_no_room;
  }
  if (group->anchor.object.id == planned.id) return false;
  const auto assets = assets_for(work, planned);
  if (!assets || assets->empty()) return false;
  auto task = prepare(work, planned, assets->front());
  if (!task) return false;
  const auto index = static_cast<std::size_t>(
      std::find(group->ids.begin(), group->ids.end(), planned.id) - group->ids.begin());
  task->object.group = name_in_scene(group->id, planned, work);
  const PlaceAdvice given = place_in_frame(work, *group, index, *task);
  if (!stand(work, *group, index, *task)) {
    if (must_stand || group->arranged.members[index].mount != Mount::surface) return false;
    return step.reason = "there was no room for it where its group has it", true;
  }
  step.has_assets = true;
  step.attempts.push_back(begun(assets->front(), given));
  enter(work, planned, assets->front(), *std::move(task));
  return true;
}

}  // namespace roomgen
