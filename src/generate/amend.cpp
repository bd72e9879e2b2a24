#include "amend.h"

#include <algorithm>
#include <set>

#include "composition/patterns.h"
#include "fits_as_it_is.h"

namespace roomgen {

namespace {

// The thing, those of its group in the scene, and what stands on any of them, in the order in which they stand.
std::vector<Object> moved_together(const Layout& layout, const Object& thing) {
  std::set<std::string> ids = {thing.id};
  const auto objects = layout.objects();
  for (const auto& object : objects)
    if (!thing.group.empty() && object.group == thing.group) ids.insert(object.id);
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

void suggest(BuildState& state, const Object& there) {
  for (auto& group : state.groups)
    if (group.anchor.object.id == there.id) group.anchor.object = there;
  for (auto& task : state.tasks)
    if (task.object.id == there.id && task.location) {
      task.location = there.position.head<2>();
      if (task.facing) task.facing = there.yaw;
    }
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
    if (const auto status = fits_as_it_is(layout, there); !status) {
      arrange_as(layout, before);
      return move.object + " was not moved: " + status.error().message;
    }
    layout.add(std::move(there));
  }
  for (const auto& object : together) suggest(work.state, *layout.find(object.id));
  return "";
}

}  // namespace

bool amend(Work& work, const PlannedObject& planned, const PlaceAdvice& advice) {
  if (!advice.bottom && !advice.size) return false;
  PlanItem item = work.item(planned);
  if (advice.bottom) item.bottom = advice.bottom, item.height.reset();
  if (advice.size) item.size = advice.size;
  work.state.amended.insert_or_assign(planned.id, std::move(item));
  return true;
}

std::vector<std::string> move_standing(Work& work, const std::vector<WantedMove>& moves) {
  std::vector<std::string> undone;
  for (const auto& move : moves)
    if (std::string why = move_one(work, move); !why.empty()) undone.push_back(std::move(why));
  return undone;
}

}  // namespace roomgen
