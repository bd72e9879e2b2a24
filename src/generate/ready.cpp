#include "ready.h"

#include <algorithm>
#include <utility>

#include "composition/plan_groups.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/room_builder.h"

namespace roomgen {

namespace {

std::vector<std::string> carriers_of(const PlanItem& item, const Plan& plan, const KindTable& kinds) {
  std::vector<std::string> carriers;
  for (const auto& planned : planned_objects(plan)) {
    const bool carries =
        planned.id == item.on || kinds.is_a(plan.items[planned.item].category, item.on);
    if (carries && carriers.size() < max_things_of_room) carriers.push_back(planned.id);
  }
  return carriers;
}

// Items of which so many are on each carrier become one for each. Once all together are more than a room
// holds, the rest stays as it is.
void count_for_each(Plan& plan, const KindTable& kinds) {
  std::size_t made = 0;
  for (std::size_t i = 0; i < plan.items.size(); ++i) {
    PlanItem item = plan.items[i];
    if (!std::exchange(item.for_each, false) || made > max_things_of_room) continue;
    const auto carriers = carriers_of(item, plan, kinds);
    made += 1 + carriers.size();
    if (carriers.empty()) continue;
    const auto at = plan.items.begin() + static_cast<std::ptrdiff_t>(i);
    plan.items.insert(plan.items.erase(at), carriers.size(), item);
    for (const auto& carrier : carriers) {
      plan.items[i].on = carrier;
      plan.items[i++].relations.push_back({RelationKind::on, carrier});
    }
    --i;
  }
}

}  // namespace

void hang_down(PlanItem& item, const KindTable& kinds, const Room& room) {
  constexpr double shortest = 0.05;  // metres
  const Kind& kind = kinds.get(item.category);
  if (item.mount != Mount::ceiling || kind.mount != Mount::ceiling || !(item.height || item.bottom))
    return;
  const double length =
      item.bottom ? room.height - *item.bottom : 2.0 * (room.height - *item.height);
  if (!item.size) item.size = kind.size;
  item.size->z() = std::clamp(length, shortest, room.height);
}

Plan ready(Plan plan, const KindTable& kinds) {
  settle(plan);
  Plan made = composition::completed(std::move(plan), kinds);
  count_for_each(made, kinds);
  for (auto& item : made.items) hang_down(item, kinds, made.room);
  return made;
}

}  // namespace roomgen
