#include "roomgen/solve/solve.h"

#include <map>

#include "arrange.h"
#include "fit_rugs.h"
#include "improve.h"
#include "place.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

Scene scene_of(const Problem& problem, const Layout& layout,
               const std::vector<PlacementTask>& tasks,
               const std::map<std::string, std::string>& reasons, const SolveOptions& options) {
  Scene scene;
  scene.prompt = problem.name;
  scene.seed = options.seed;
  scene.room = problem.room;
  for (const auto& task : tasks) {
    if (const Object* placed = layout.find(task.object.id)) {
      scene.objects.push_back(with_rounded_pose(*placed));
    } else {
      const auto reason = reasons.find(task.object.id);
      scene.unplaced.push_back(
          {task.object.id, task.object.category,
           reason == reasons.end() ? "stopped before it was tried" : reason->second});
    }
  }
  pile_rugs(scene.objects);
  scene.incomplete = options.cancel.cancelled();
  return scene;
}

// Places everything with all constraints held, or nothing. Not for tasks with a suggested location:
// being near it may be worth a constraint.
bool place_all_at_once(Layout& layout, const std::vector<PlacementTask>& tasks,
                       const SolveOptions& options, Random& random) {
  std::vector<const PlacementTask*> all;
  for (const auto& task : tasks) {
    if (task.location) return false;
    all.push_back(&task);
  }
  ArrangeOptions arrange_options;
  arrange_options.pitch = 2.0 * options.place.pitch;
  arrange_options.cancel = options.cancel;
  if (!arrange(layout, all, arrange_options, random)) return false;
  polish(layout, tasks, options.place, options.cancel, random);
  return true;
}

// One thing after the other, each with an eye on those to come, then repairs.
int place_one_by_one(Layout& layout, const std::vector<PlacementTask>& tasks,
                     std::map<std::string, std::string>& reasons, const SolveOptions& options,
                     Random& random) {
  PlaceOptions place_options = options.place;
  place_options.cancel = options.cancel;
  for (std::size_t i = 0; i < tasks.size() && !options.cancel.cancelled(); ++i) {
    const std::span<const PlacementTask> later(tasks.data() + i + 1, tasks.size() - i - 1);
    auto placed = place(layout, tasks[i], later, place_options, random);
    if (placed)
      layout.add(placed->object);
    else if (placed.error().kind != Error::Kind::cancelled)
      reasons[tasks[i].object.id] = placed.error().message;
  }
  ImproveOptions improve_options;
  improve_options.place = options.place;
  improve_options.rounds = options.rounds;
  improve_options.cancel = options.cancel;
  return improve(layout, tasks, reasons, improve_options, random);
}

}  // namespace

Result<Solution> solve(const Problem& problem, const ModelTable& models,
                       const KindTable& categories, const SolveOptions& options) {
  if (auto status = options.place.validate(); !status) return status.error();
  const auto order = placement_order(problem.tasks);
  if (!order) return order.error();
  std::vector<PlacementTask> tasks;
  for (std::size_t i : *order) tasks.push_back(problem.tasks[i]);

  Layout layout(problem.room, categories, models, nullptr, options.place.weights);
  Random random(options.seed);
  std::map<std::string, std::string> reasons;
  Solution solution;
  if (!options.layout_search || !place_all_at_once(layout, tasks, options, random))
    solution.rounds = place_one_by_one(layout, tasks, reasons, options, random);
  solution.scene = scene_of(problem, layout, tasks, reasons, options);
  for (const auto& task : tasks)
    solution.constraints += static_cast<int>(task.object.relations.size());
  for (const auto& verdict : judge_scene(solution.scene, categories))
    solution.held += verdict.judgement.held ? 1 : 0;
  return solution;
}

}  // namespace roomgen
