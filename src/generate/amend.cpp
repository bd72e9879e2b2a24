#include "amend.h"

#include <algorithm>
#include <optional>
#include <set>

#include "builder_steps.h"
#include "composition/patterns.h"
#include "fits_as_it_is.h"
#include "ready.h"

namespace roomgen {

namespace {

// The thing, if it is the first of its group in the scene all of that, and what stands on any of
// them, in the order in which they stand.
std::vector<Object> moved_together(const Layout& layout, const Object& thing) {
  std::set<std::string> ids = {thing.id};
  const auto objects = layout.objects();
  const auto is_of_group = [&](const Object& object) { return object.group == thing.group; };
  const auto first = std::find_if(objects.begin(), objects.end(), is_of_group);
  if (!thing.group.empty() && first->id == thing.id)
    for (const auto& object : objects)
      if (is_of_group(object)) ids.insert(object.id);
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& object : objects)
      if (!object.on.empty() && ids.count(object.on) && ids.insert(object.id).second) grown = true;
  }
  std::vector<Object> together;
  for (const auto& object : objects)
    if (ids.count(object.id)) together.push_back(object);
  return together;
}

Object carried(const Object& object, const Object& thing, const WantedMove& move) {
  const double yaw = move.yaw.value_or(thing.yaw);
  const composition::Place frame{thing.position.head<2>(), thing.yaw};
  const Vec2 off = rotated(Vec2(object.position.head<2>() - frame.position), -frame.yaw);
  const auto at = composition::within({move.location, yaw}, {off, object.yaw - frame.yaw});
  Object there = object;
  there.position.head<2>() = at.position;
  there.yaw = wrap_angle(at.yaw);
  return there;
}

void suggest(BuildState& state, const Object& there, bool with_group) {
  for (auto& group : state.groups)
    if (group.anchor.object.id == there.id) group.anchor.object = there;
    else if (!with_group)
      group.posts.erase(there.id);
  for (auto& task : state.tasks)
    if (task.object.id == there.id && task.location) {
      if (task.object.on != there.on) task.object.relations = there.relations;
      task.object.on = there.on;
      task.location = there.position.head<2>();
      if (task.facing) task.facing = there.yaw;
    }
}

// On what is there about as high as it stood, as its own top; as it is where nothing carries it.
Object resting_there(const Layout& layout, const Object& object) {
  const WantedPose wanted{object.position.head<2>(), object.yaw, bottom(object), {}};
  Object rest = resting(layout, object, wanted).value_or(object);
  for (auto& relation : rest.relations)
    if (relation == Relation{RelationKind::on, object.on}) relation.target = rest.on;
  return rest;
}

// Why not; empty if it was done.
std::string move_one(Work& work, const WantedMove& move) {
  Layout& layout = work.layout();
  const Object* standing = layout.find(move.object);
  if (!standing) return move.object + " does not stand";
  const Object thing = *standing;
  const auto all = layout.objects();
  const std::vector<Object> before(all.begin(), all.end());
  const auto together = moved_together(layout, thing);
  for (auto object = together.rbegin(); object != together.rend(); ++object) layout.remove(object->id);
  for (const auto& object : together) {
    Object there = carried(object, thing, move);
    if (object.id == thing.id && thing.mount == Mount::surface)
      there = resting_there(layout, there);
    if (const auto status = fits_as_it_is(layout, there); !status) {
      arrange_as(layout, before);
      return move.object + " was not moved: " + status.error().message;
    }
    layout.add(std::move(there));
  }
  for (const auto& object : together)
    suggest(work.state, *layout.find(object.id), object.id != thing.id);
  return "";
}

const Relation* said(const PlaceAdvice& advice, RelationKind kind,
                     std::optional<RelationKind> or_kind = {}) {
  for (const auto& relation : advice.relations)
    if (relation.kind == kind || relation.kind == or_kind) return &relation;
  return nullptr;
}

// What carries it on top or inside, if the answer names such a thing.
const Object* said_carrier(const Work& work, const PlaceAdvice& advice) {
  const Relation* on = said(advice, RelationKind::on, RelationKind::inside);
  const Object* carrier = on ? work.layout().find(on->target) : nullptr;
  return carrier && !carrier->traits.flat ? carrier : nullptr;
}

// Up, by the height or what it is above; at a wall, or amidst the room.
struct SaidStance {
  bool hangs, above, wall, near_wall, amidst;
};

SaidStance stance_of(const PlaceAdvice& advice, const Room& room) {
  constexpr double hangs_from = 0.1, at_wall = 0.35, far_off_walls = 0.8;  // metres
  const double off =
      advice.location ? distance_to_boundary(room.polygon, *advice.location) : at_wall;
  SaidStance stance{advice.bottom.value_or(0.0) > hangs_from,
                    said(advice, RelationKind::above) != nullptr,
                    said(advice, RelationKind::edge, RelationKind::corner) != nullptr};
  stance.near_wall = stance.wall || off <= at_wall;
  stance.amidst = said(advice, RelationKind::middle, RelationKind::around) ||
                  (off > far_off_walls && !stance.wall && !stance.above);
  return stance;
}

// How an answer says that a thing is put up, against what its kind is used to.
Mount said_mount(const Work& work, const PlaceAdvice& advice, Mount usual) {
  if (said_carrier(work, advice)) return Mount::surface;
  if (said(advice, RelationKind::hang_from)) return Mount::ceiling;
  const SaidStance stance = stance_of(advice, work.place.room);
  const bool hangs = stance.hangs || (stance.above && usual == Mount::floor);
  if (usual == Mount::surface && stance.wall) return hangs ? Mount::wall : Mount::floor;
  if (usual == Mount::floor && hangs) return stance.near_wall ? Mount::wall : Mount::ceiling;
  if (usual == Mount::wall && stance.amidst) return hangs ? Mount::ceiling : Mount::floor;
  return usual;
}

// From whose underside it hangs: by what is said, or because that is over where it is said to hang.
const Object* said_beam(const Work& work, const PlaceAdvice& advice, const PlanItem& item) {
  if (const Relation* from = said(advice, RelationKind::hang_from))
    return work.layout().find(from->target);
  if (item.mount != Mount::ceiling || !item.bottom || !advice.location) return nullptr;
  const double least = *item.bottom + (item.size ? item.size->z() : 0.0);
  for (const auto& object : work.layout().objects())
    if (object.mount == Mount::ceiling && bottom(object) >= least &&
        contains(footprint(object), *advice.location))
      return &object;
  return nullptr;
}

}  // namespace

bool amend(Work& work, const PlannedObject& planned, const PlaceAdvice& advice) {
  PlanItem item = work.item(planned);
  const PlanItem before = item;
  if (advice.bottom) item.bottom = advice.bottom, item.height.reset();
  if (advice.size) item.size = advice.size;
  if (!advice.usual) {
    item.mount = said_mount(work, advice, item.mount);
    if (const Object* carrier = said_carrier(work, advice)) item.on = carrier->id;
    if (const Object* beam = said_beam(work, advice, item)) {
      std::erase_if(item.relations,
                    [](const Relation& one) { return one.kind == RelationKind::hang_from; });
      item.relations.push_back({RelationKind::hang_from, beam->id});
    }
  }
  hang_down(item, work.place.categories, work.place.room);
  const bool is_other = advice.bottom || advice.size || item.mount != before.mount ||
                        item.relations != before.relations;
  if (is_other) work.state.amended.insert_or_assign(planned.id, std::move(item));
  return is_other;
}

std::vector<std::string> move_standing(Work& work, const std::vector<WantedMove>& moves) {
  std::vector<std::string> undone;
  std::vector<WantedMove> left = moves;
  for (std::size_t before = left.size() + 1;
       left.size() < before;) {  // what was in the way may be gone
    before = left.size();
    undone.clear();
    std::erase_if(left, [&](const WantedMove& move) {
      std::string why = move_one(work, move);
      if (!why.empty()) undone.push_back(why);
      return why.empty();
    });
  }
  return undone;
}

}  // namespace roomgen
