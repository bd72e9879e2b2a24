#include "check_kind.h"

#include <algorithm>

#include "brief/outline.h"
#include "brief/room_kinds.h"
#include "plan/least_size.h"
#include "plan/room_makers.h"
#include "plan/room_openings.h"
#include "solve/dry_run.h"

namespace roomgen {

namespace {

using brief::RoomKind;

// Of a kind that needs something to be what it is; else none.
const RoomKind* kind_of(const Room& room) {
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds) return nullptr;
  const auto found = kinds->types.find(room.type);
  return found == kinds->types.end() || found->second.made_by.empty() ? nullptr : &found->second;
}

bool stands(const BuildState& state, const std::string& id) {
  return std::any_of(state.objects.begin(), state.objects.end(),
                     [&](const Object& object) { return object.id == id; });
}

// One of each item that makes the room, alone in a rectangle with the door that such a room has.
Plan alone(const Workplace& place, const RoomKind& kind, const Vec2& size) {
  Plan plan;
  plan.seed = place.plan.seed;
  plan.room.type = kind.type;
  plan.room.height = place.room.height;
  plan.room.polygon = brief::rectangle_of(size).polygon;
  plan::ensure_door(plan.room, kind, plan.notes);
  for (const auto& item : place.plan.items) {
    if (!place.categories.is_any_of(item.category, kind.made_by)) continue;
    PlanItem one = item;
    one.quantity = 1;
    one.relations.clear();
    one.location.reset();
    one.facing.reset();
    plan.items.push_back(std::move(one));
  }
  return plan;
}

// With boxes, then with meshes.
bool finds_a_place(const Workplace& place, const Plan& plan) {
  if (place.options.cancel.cancelled() || !built_in_arrangements()) return false;
  const DryRun run = dry_run(plan, place.categories, *built_in_arrangements());
  if (run.missed.size() == plan.items.size()) return false;
  const auto designer = make_rule_designer();
  BuildOptions options;
  options.place = place.options.place;
  options.seed = place.options.seed;
  options.cancel = place.options.cancel;
  auto builder = RoomBuilder::begin(plan, *designer, place.library, place.categories, options);
  while (builder && builder->next())
    if (const auto step = builder->step(); !step || step->reason.empty()) return step.ok();
  return false;
}

}  // namespace

Status check_kind(const Workplace& place, const BuildState& state) {
  const RoomKind* kind = kind_of(place.room);
  const bool is_over = state.left.empty() && state.stopped.empty() && !state.is_cut &&
                       !place.options.cancel.cancelled();
  if (!kind || !is_over) return {};
  std::vector<std::string> missing;
  for (const auto& planned : planned_objects(place.plan)) {
    const std::string& category = place.plan.items[planned.item].category;
    if (!place.categories.is_any_of(category, kind->made_by)) continue;
    if (stands(state, planned.id)) return {};
    if (std::find(missing.begin(), missing.end(), category) == missing.end())
      missing.push_back(category);
  }
  if (missing.empty()) return {};
  const auto works = [&](const Vec2& size) {
    return finds_a_place(place, alone(place, *kind, size));
  };
  return plan::no_place_for(missing, place.room,
                            plan::least_size(bounds(place.room.polygon).size(), works));
}

}  // namespace roomgen
