#include "loads.h"

#include <algorithm>
#include <limits>

namespace roomgen {

namespace {

// Things may become this much smaller on what carries them.
constexpr double least_load = 0.8;

}  // namespace

std::vector<Load> loads_on(const std::string& id, const Plan& plan,
                           const KindTable& categories) {
  std::vector<Load> loads;
  for (const auto& item : plan.items) {
    const auto wants = [&](RelationKind kind) {
      return std::find(item.relations.begin(), item.relations.end(), Relation{kind, id}) !=
             item.relations.end();
    };
    if (item.mount != Mount::surface || !wants(RelationKind::on)) continue;
    const Kind& category = categories.get(item.category);
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
