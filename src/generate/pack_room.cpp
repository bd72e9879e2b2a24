#include "pack_room.h"

#include <algorithm>

#include "optimise/pack.h"

namespace roomgen {

namespace {

// Only what has an asset can be arranged.
bool is_left_out(const Work& work) {
  return std::ranges::any_of(work.state.tasks, [&](const PlacementTask& task) {
    return !work.layout().find(task.object.id);
  });
}

std::vector<PackThing> things_of(const Work& work) {
  std::vector<PackThing> things;
  for (const auto& task : work.state.tasks) {
    PackThing thing;
    const Object* standing = work.layout().find(task.object.id);
    thing.object = standing ? *standing : task.object;
    thing.stands = standing != nullptr;
    const bool covers = work.place.categories.get(thing.object.category).covers_window;
    thing.movable = !thing.object.locked && !(standing && (task.binding || covers));
    thing.asked = task.asked;
    thing.wishes = task.wishes;
    if (standing || !covers) things.push_back(std::move(thing));
  }
  return things;
}

}  // namespace

void pack_room(Work& work) {
  const BuildOptions& options = work.place.options;
  if (options.layout == LayoutSearch::steps || !is_left_out(work)) return;
  PackOptions how;
  how.seed = options.seed;
  how.steps = options.pack_steps;
  how.cancel = work.cancel;
  const Packing packing = pack(work.place.room, things_of(work), work.place.models, work.place.categories, how);
  if (!packing.is_better) return;
  arrange_as(work.layout(), packing.objects);
  for (const auto& object : packing.objects) work.state.reasons.erase(object.id);
  for (const auto& task : work.state.tasks)
    if (!work.layout().find(task.object.id) && !work.state.reasons.contains(task.object.id))
      work.state.reasons[task.object.id] = "made way for what was asked for";
}

}  // namespace roomgen
