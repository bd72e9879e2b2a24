#include "improve.h"
#include "place.h"
#include "quality.h"

namespace roomgen {

namespace {

// The task and those that depend on it.
std::vector<PlacementTask> with_dependants(const PlacementTask& task,
                                           const std::vector<PlacementTask>& tasks) {
  std::vector<PlacementTask> result = {task};
  for (const auto& other : tasks)
    if (depends_on(other.object, task.object.id)) result.push_back(other);
  return result;
}

}  // namespace

void polish(Layout& layout, const std::vector<PlacementTask>& tasks, PlaceOptions options,
            const CancelToken& cancel, Random& random) {
  options.grid = GridUse::never;
  options.max_exact_tests = 12;
  options.cancel = cancel;
  for (const auto& task : tasks) {
    if (cancel.cancelled()) return;
    const Object* placed = layout.find(task.object.id);
    if (!placed || placed->locked || task.binding) continue;
    if (layout.carries_something(task.object.id)) continue;  // it would leave its things in the air
    const Object before = *placed;
    const auto affected = with_dependants(task, tasks);
    const LayoutQuality quality_before = quality(layout, affected);
    layout.remove(before.id);
    const auto again = place(layout, task, {}, options, random);
    if (again) layout.add(again->object);
    if (again && quality(layout, affected).better_than(quality_before)) continue;
    layout.remove(before.id);
    layout.add(before);
  }
}

}  // namespace roomgen
