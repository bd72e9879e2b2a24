#include <algorithm>
#include <string>

#include "clauses.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

namespace {

constexpr double width_of_one = 0.6;  // metres, of a seat for several

int seats_on(const Object& object, const KindTable& kinds) {
  if (!kinds.is_any_of(object.category, {"seat", "chair", "stool", "bench"})) return 0;
  if (kinds.is_any_of(object.category, {"chair", "stool", "armchair"})) return 1;
  return std::max(1, static_cast<int>(object.size.x() / width_of_one));
}

}  // namespace

Finding judge_seats(const Requirement& requirement, const Scene& scene, const KindTable& kinds) {
  int seats = 0;
  for (const auto& object : scene.objects) seats += seats_on(object, kinds);
  return by_fault(seats >= requirement.amount ? "" : seats == 1 ? "there is a seat for one" : "there are seats for " + std::to_string(seats));
}

}  // namespace roomgen
