#include "rehearsal.h"

#include <algorithm>

#include "advise.h"
#include "holding.h"
#include "sketch.h"

namespace roomgen::design {

namespace {

constexpr double size_margin = 1.05;
constexpr double loose_gap = 0.1;  ///< metres beyond what the pair prefers

Object object_of(const PlannedObject& planned, const PlanItem& item, const Kind& category) {
  Object object;
  object.id = planned.id;
  object.category = item.category;
  object.traits = category.traits;
  object.size = item.size.value_or(category.size);
  // Real ones may be a little larger.
  if (item.asked && item.mount == Mount::floor) object.size.head<2>() *= size_margin;
  object.mount = item.mount;
  return object;
}

void put(Object& object, const PlaceAdvice& advice, const Kind& category, const Scene& scene) {
  object.position.head<2>() = *advice.location;
  object.yaw = *advice.yaw;
  object.position.z() = usual_bottom(object, category, scene.room);
  for (const auto& relation : advice.relations)
    if (relation.kind == RelationKind::on && object.mount == Mount::surface)
      if (const Object* carrier = find_object(scene, relation.target)) {
        object.on = carrier->id;
        object.position.z() = top(*carrier);
      }
}

// Near in name only: who asks for "next to" wants no gap to walk through.
bool is_loose(const Placed& placed, const ResolvedRelation& relation) {
  if (relation.kind != RelationKind::near) return false;
  return std::none_of(relation.targets.begin(), relation.targets.end(), [&](const Footprint& target) {
    return gap(placed.footprint, target) <= relation.gap_high + loose_gap;
  });
}

int broken_relations(const Scene& scene, const Object& object, const PlanItem& item,
                     const KindTable& table, const Arrangements& arrangements) {
  if (item.relations.empty()) return 0;
  const Sketch sketch(scene, table, arrangements);
  const Placed placed{
      &object, {object.position.head<2>(), object.yaw}, footprint(object), object.position.z()};
  const auto resolved = resolve_all(sketch, object, item.relations);
  int broken = static_cast<int>(std::count_if(
      resolved.begin(), resolved.end(),
      [&](const ResolvedRelation& relation) { return !holds(sketch, placed, relation); }));
  if (object.mount == Mount::floor)
    broken += static_cast<int>(std::count_if(
        resolved.begin(), resolved.end(),
        [&](const ResolvedRelation& relation) { return is_loose(placed, relation); }));
  return broken;
}

}  // namespace

Rehearsal rehearse(const Plan& plan, const KindTable& table, const Arrangements& arrangements) {
  Scene scene;
  scene.room = plan.room;
  Rehearsal rehearsal;
  for (const auto& planned : planned_objects(plan)) {
    const PlanItem& item = plan.items[planned.item];
    const Kind& category = table.get(item.category);
    if (category.covers_window) continue;  // it hangs where the windows are
    Object object = object_of(planned, item, category);
    const PlaceRequest request{plan, scene, planned, object};
    const PlaceAdvice advice = advise(request, table, arrangements);
    if (!advice.location || !advice.yaw) {
      rehearsal.missed.push_back(planned);
      continue;
    }
    put(object, advice, category, scene);
    rehearsal.broken += broken_relations(scene, object, item, table, arrangements);
    scene.objects.push_back(std::move(object));
  }
  return rehearsal;
}

}  // namespace roomgen::design
