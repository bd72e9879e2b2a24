#include "order.h"

#include <algorithm>
#include <set>

#include "support.h"

namespace roomgen {

std::optional<PlannedObject> next_of(const BuildState& state) {
  if (state.left.empty()) return std::nullopt;
  const auto wanted =
      std::find_if(state.left.begin(), state.left.end(),
                   [&](const PlannedObject& planned) { return planned.id == state.next; });
  return wanted == state.left.end() ? state.left.front() : *wanted;
}

std::vector<std::string> may_come_next(const Work& work) {
  const auto& items = work.place.plan.items;
  std::set<std::size_t> left;
  for (const auto& planned : work.state.left) left.insert(planned.item);
  const auto waits = [&](const PlanItem& item) {
    return item.mount == Mount::surface &&
           std::any_of(left.begin(), left.end(), [&](std::size_t i) {
             return could_carry(work.place.categories, items[i].category, item.on);
           });
  };
  std::vector<std::string> ids;
  for (const auto& planned : work.state.left)
    if (!waits(items[planned.item])) ids.push_back(planned.id);
  return ids;
}

}  // namespace roomgen
