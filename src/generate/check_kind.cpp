#include <algorithm>

#include "brief/room_kinds.h"
#include "builder_steps.h"
#include "plan/room_makers.h"

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

}  // namespace

Status check_kind(const Workplace& place, const BuildState& state) {
  const RoomKind* kind = kind_of(place.room);
  const bool is_over = state.left.empty() && state.stopped.empty() && !state.is_cut &&
                       !place.options.cancel.cancelled();
  if (!kind || !is_over) return {};
  std::vector<std::string> missing;
  for (const auto& planned : planned_objects(place.plan)) {
    const PlanItem& item = place.plan.items[planned.item];
    const std::string& category = item.category;
    if (!item.left_out.empty() || !place.categories.is_any_of(category, kind->made_by)) continue;
    if (find_object(state.objects, planned.id)) return {};
    if (std::find(missing.begin(), missing.end(), category) == missing.end())
      missing.push_back(category);
  }
  if (missing.empty()) return {};
  return plan::no_place_for(missing, place.room);
}

}  // namespace roomgen
