#include "starts.h"

#include <algorithm>

#include "arrange.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

// Beside it the degrees of poses are small: a search takes what it comes upon.
constexpr double start_noise = 3.0;
constexpr int start_tries = 6;

std::vector<Relation> held_relations(const Scene& scene, const Object& object, const KindTable& kinds) {
  const auto resolved = resolve(object, scene.room, scene.objects, kinds);
  const Subject subject{footprint(object), bottom(object), top(object)};
  std::vector<Relation> held;
  for (std::size_t i = 0; i < resolved.size(); ++i)
    if (judge(resolved[i], subject, scene.room).held) held.push_back(object.relations[i]);
  return held;
}

}  // namespace

Result<Scene> in_placement_order(Scene scene) {
  std::vector<PlacementTask> tasks(scene.objects.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i].object = scene.objects[i];
  const auto order = placement_order(tasks);
  if (!order) return order.error();
  for (std::size_t i = 0; i < tasks.size(); ++i) scene.objects[i] = std::move(tasks[(*order)[i]].object);
  return scene;
}

Start start_of(const Scene& scene, const KindTable& kinds) {
  Start start;
  for (const auto& object : scene.objects) {
    PlacementTask task;
    task.object = object;
    task.object.relations = held_relations(scene, object, kinds);
    start.tasks.push_back(std::move(task));
    start.poses.push_back({object.position.head<2>(), bottom(object), object.yaw});
  }
  return start;
}

std::optional<Poses> another_start(Layout& layout, const Start& start, const Random& random,
                                   const CancelToken& cancel) {
  std::vector<const PlacementTask*> moving;
  const auto stays = immovable(start.tasks, layout.categories());
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (stays[i]) layout.add(start.tasks[i].object);
    else moving.push_back(&start.tasks[i]);
  }
  ArrangeOptions options;
  options.tries = start_tries;
  options.noise = start_noise;
  options.first_without_noise = false;
  options.cancel = cancel;
  Random own = random;
  std::optional<Poses> poses;
  if (arrange(layout, moving, options, own)) {
    poses.emplace();
    for (const auto& task : start.tasks) {
      const Object& placed = *layout.find(task.object.id);
      poses->push_back({placed.position.head<2>(), bottom(placed), placed.yaw});
    }
  }
  layout.clear();
  return poses;
}

}  // namespace roomgen
