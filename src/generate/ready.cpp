#include "ready.h"

#include <algorithm>

#include "composition/plan_groups.h"
#include "roomgen/design/designer.h"

namespace roomgen {

namespace {

constexpr double shortest = 0.05;  // metres

// What hangs from the ceiling is as long as it is to hang down: a pendant lamp has the cord for it.
void hang_down(PlanItem& item, const KindTable& kinds, const Room& room) {
  if (item.mount != Mount::ceiling || !(item.height || item.bottom)) return;
  const double length = item.bottom ? room.height - *item.bottom : 2.0 * (room.height - *item.height);
  if (!item.size) item.size = kinds.get(item.category).size;
  item.size->z() = std::clamp(length, shortest, room.height);
}

}  // namespace

Plan ready(Plan plan, const KindTable& kinds) {
  settle(plan);
  Plan made = composition::completed(std::move(plan), kinds);
  for (auto& item : made.items) hang_down(item, kinds, made.room);
  return made;
}

}  // namespace roomgen
