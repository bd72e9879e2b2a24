#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "composition/plan_groups.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::test {

inline Plan plan_of(const std::string& prompt, std::uint64_t seed = 0) {
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  return *make_rule_designer()->plan(request);
}

/// How many things of a category a plan holds, descendants included.
inline int count_of(const Plan& plan, const std::string& category) {
  int count = 0;
  for (const auto& item : plan.items)
    if (KindTable::built_in().is_a(item.category, category)) count += item.quantity;
  return count;
}

/// Where the things of the first block of a plan stand (rows, a ring, islands; without their seats and what stands on
/// them): in the room, or in the frame of the first where the solver has yet to place it.
inline std::vector<Footprint> in_block(const Plan& plan) {
  std::vector<Footprint> placed;
  const auto is_block = [](const PlanGroup& one) { return !one.definition.empty(); };
  const auto group = std::find_if(plan.groups.begin(), plan.groups.end(), is_block);
  if (group == plan.groups.end()) return placed;
  const KindTable& kinds = KindTable::built_in();
  const auto asked = std::find_if(plan.items.begin(), plan.items.end(), [&](const PlanItem& item) {
    return item.group == group->id && item.part.starts_with("unit") && item.asked;
  });
  const auto ways = composition::ways_to_stand(plan, *group, kinds, {});
  if (asked == plan.items.end() || !ways) return placed;
  const composition::Place frame{group->location.value_or(Vec2::Zero()), group->facing.value_or(0.0)};
  for (const auto& member : ways->front().members) {
    const auto at = composition::within(frame, member.place);
    if (member.category == asked->category)
      placed.emplace_back(at.position, member.size.head<2>(), at.yaw, kinds.get(member.category).traits.round);
  }
  return placed;
}

inline const char* const room_types[] = {"bedroom",  "living room", "kitchen",
                                         "bathroom", "dining room", "balcony"};

}  // namespace roomgen::test
