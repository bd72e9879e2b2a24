#include "loads.h"

#include <algorithm>
#include <limits>
#include <set>

namespace roomgen {

namespace {

// Things may become this much smaller on what carries them.
constexpr double least_load = 0.8;

}  // namespace

std::vector<Load> loads_on(const std::string& id, const Workplace& place) {
  std::vector<Load> loads;
  std::set<std::size_t> in_groups;  // items
  for (const auto& planned : planned_objects(place.plan))
    if (const auto carrier = place.carriers.find(planned.id);
        carrier != place.carriers.end() && carrier->second == id)
      in_groups.insert(planned.item);
  for (std::size_t i = 0; i < place.plan.items.size(); ++i) {
    const PlanItem& item = place.plan.items[i];
    const auto wants = [&](RelationKind kind) {
      return std::find(item.relations.begin(), item.relations.end(), Relation{kind, id}) !=
             item.relations.end();
    };
    if (item.mount != Mount::surface ||
        !(wants(RelationKind::on) || in_groups.count(i) > 0))
      continue;
    const Kind& category = place.categories.get(item.category);
    Load load;
    load.object.category = item.category;
    load.object.size = least_load * item.size.value_or(category.size);
    load.object.mount = Mount::surface;
    load.inside = wants(RelationKind::inside);
    loads.push_back(std::move(load));
  }
  return loads;
}

bool can_carry(const Object& carrier, std::span<const Load> loads, const SupportPoses& poses) {
  return std::all_of(loads.begin(), loads.end(), [&](const Load& load) {
    const double highest = load.inside ? carrier.size.z() - 0.5 * load.object.size.z()
                                       : std::numeric_limits<double>::infinity();
    return poses.carries(load.object, carrier, highest);
  });
}

}  // namespace roomgen
