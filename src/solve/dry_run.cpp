#include "dry_run.h"

#include <algorithm>

#include "place.h"
#include "scene/judgement.h"
#include "support.h"

namespace roomgen {

namespace {

constexpr double size_margin = 1.05;
constexpr double loose_gap = 0.1;  ///< metres beyond what the pair prefers
// Of what usually stands and is to hang on a wall.
constexpr double usual_elevation = 1.2;
// A box that passes the cheap tests nearly always passes the others.
constexpr int most_exact_tests = 60;

// Near in name only: who asks for "next to" wants no gap to walk through.
bool is_loose(const ResolvedRelation& relation, const Footprint& own) {
  return relation.kind == RelationKind::near &&
         std::none_of(relation.targets.begin(), relation.targets.end(),
                      [&](const Footprint& target) {
                        return gap(own, target) <= relation.gap_high + loose_gap;
                      });
}

int count_broken(const Layout& layout, Object object, const PlanItem& item) {
  if (item.relations.empty()) return 0;
  object.relations = item.relations;
  const Subject subject{footprint(object), bottom(object), top(object)};
  int broken = 0;
  for (const auto& relation :
       resolve(object, layout.room(), layout.objects(), layout.categories())) {
    broken += judge(relation, subject, layout.room()).held ? 0 : 1;
    broken += object.mount == Mount::floor && is_loose(relation, subject.footprint) ? 1 : 0;
  }
  return broken;
}

PlacementTask task_for(const Plan& plan, const PlannedObject& planned, const Layout& layout) {
  const PlanItem& item = plan.items[planned.item];
  const Kind& category = layout.categories().get(item.category);
  PlacementTask task;
  Object& object = task.object;
  object.id = planned.id;
  object.category = item.category;
  object.traits = category.traits;
  object.size = item.size.value_or(category.size);
  // Real ones may be a little larger.
  if (item.asked && item.mount == Mount::floor) object.size.head<2>() *= size_margin;
  object.mount = item.mount;
  object.position.z() =
      mounting_height(item.mount, object.size.z(),
                      category.mount == Mount::wall ? category.elevation : usual_elevation,
                      layout.room());
  object.relations = known_relations(item.relations, layout.room(), layout.objects());
  task.location = item.location;
  task.facing = item.facing;
  task.binding = item.location.has_value();
  task.asked = item.asked;
  task.wishes = item.asked ? static_cast<int>(object.relations.size()) : 0;
  task.usual = true;
  task.anywhere = item.asked;
  task.of_its_kind = quantity_of(plan, item.category);
  return task;
}

// Of a small thing it is enough to know that boxes leave it room.
std::optional<Object> place_as_box(Layout& layout, const PlanItem& item, PlacementTask task) {
  if (item.mount == Mount::surface)
    if (const auto spot = choose_support(layout, item.on, 0, task))
      return at_pose(task.object, *spot);
  PlaceOptions options;
  options.max_exact_tests = most_exact_tests;
  Random random(0);
  auto placed = place(layout, task, {}, options, random);
  if (!placed) return std::nullopt;
  return std::move(placed->object);
}

}  // namespace

DryRun dry_run(const Plan& plan, const KindTable& categories,
               const Arrangements& arrangements,
               const std::function<bool(const DryRun&)>& is_hopeless) {
  const ModelTable boxes;
  Layout layout(plan.room, categories, boxes, &arrangements);
  DryRun result;
  for (const auto& planned : planned_objects(plan)) {
    const PlanItem& item = plan.items[planned.item];
    if (categories.get(item.category).covers_window) continue;  // it hangs where the windows are
    auto placed = place_as_box(layout, item, task_for(plan, planned, layout));
    const int broken = placed ? count_broken(layout, *placed, item) : 0;
    result.broken += broken;
    if (placed)
      layout.add(*std::move(placed));
    else
      result.missed.push_back(planned);
    if ((broken > 0 || !placed) && is_hopeless && is_hopeless(result)) break;
  }
  return result;
}

}  // namespace roomgen
