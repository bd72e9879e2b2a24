#include "roomgen/solve/solve.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <thread>

#include "base/threads.h"
#include "chain.h"
#include "distinct.h"
#include "scene/judgement.h"
#include "starts.h"

namespace roomgen {

namespace {

// Accepted steps between two layouts of a chain, for each thing: about all of them have moved.
constexpr double steps_a_thing = 1.0;
// Steps that are tried for one layout at most, for each thing.
constexpr int most_tries_a_thing = 100;
// Layouts that each chain draws in a round: first few, then more.
constexpr std::size_t first_batch = 4, most_batch = 32;
// No more is to be found when so many layouts in a row held fewer new ones than this share.
constexpr std::size_t barren_draws = 1024;
constexpr double least_new = 0.005;

/// What one thread works with; equal ones give equal layouts.
struct Worker {
  Worker(const Scene& base, const ModelTable& models, const KindTable& kinds)
      : scene(base), layout(base.room, kinds, models) {}

  Scene scene;  ///< to judge layouts by
  Layout layout;
  std::unique_ptr<Ensemble> ensemble;
};

struct ChainRun {
  ChainState state;
  std::vector<SampledLayout> drawn;
};

int count_constraints(const std::vector<Object>& objects) {
  std::size_t count = 0;
  for (const auto& object : objects) count += object.relations.size();
  return static_cast<int>(count);
}

Status check_amount(std::size_t things, std::size_t layouts) {
  if (things > most_sampled_things)
    return Error{Error::Kind::limit, "layouts are drawn of rooms of up to " +
                                         std::to_string(most_sampled_things) +
                                         " things, and this has " + std::to_string(things) +
                                         ": leave some out, or draw of "
                                         "each part of the room by itself"};
  if (things == 0 || layouts <= most_sampled_poses / things) return {};
  return Error{Error::Kind::limit,
               std::to_string(layouts) + " layouts of " + std::to_string(things) +
                   " things are too many at once: draw up to " +
                   std::to_string(most_sampled_poses / things) + ", and others with another seed"};
}

class Sampler {
 public:
  Sampler(const Scene& scene, int constraints, RugRule rugs, const ModelTable& models, const KindTable& kinds,
          const SampleOptions& options)
      : kinds_(kinds), options_(options), rugs_(std::move(rugs)), start_(start_of(scene, kinds)) {
    samples_.scene = scene;
    samples_.seed = options.solve.seed;
    samples_.constraints = constraints;
    const unsigned wanted = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
    chains_.resize(std::max<std::size_t>(1, options.chains));
    const std::size_t threads = std::min<std::size_t>(wanted, chains_.size());
    for (std::size_t i = 0; i < threads; ++i) workers_.push_back(std::make_unique<Worker>(scene, models, kinds));
  }

  Samples run() {
    begin();
    DistinctLayouts distinct(movables_, options_.apart);
    std::size_t barren = 0, batch = first_batch;
    while (samples_.layouts.size() < options_.count && barren < barren_draws && !options_.solve.cancel.cancelled()) {
      const std::size_t found_before = samples_.layouts.size(), drawn_before = samples_.drawn;
      draw(batch);
      gather(distinct);
      const std::size_t drawn = samples_.drawn - drawn_before, found = samples_.layouts.size() - found_before;
      if (drawn == 0) break;  // no chain stands anywhere
      barren = static_cast<double>(found) < least_new * static_cast<double>(drawn) ? barren + drawn : 0;
      batch = std::min(2 * batch, most_batch);
    }
    return std::move(samples_);
  }

 private:
  // Each call has a worker to itself; which one makes no difference.
  void for_each_chain(const std::function<void(Worker&, std::size_t)>& work) {
    share_out(chains_.size(), workers_.size(),
              [&](std::size_t thread, std::size_t i) { work(*workers_[thread], i); });
  }

  // The first chain starts from what is varied, the others wherever a search ends.
  void begin() {
    for_each_chain([this](Worker& worker, std::size_t i) {
      ChainState& state = chains_[i].state;
      state.random = Random(options_.solve.seed, i + 1);
      state.poses = start_.poses;
      if (i > 0) start_anew(worker, state);
    });
    std::vector<Poses> examples;
    for (const auto& chain : chains_) examples.push_back(chain.state.poses);
    movables_ = make_movables(workers_.front()->layout, start_.tasks, examples);
    for (auto& worker : workers_) {
      fill(worker->layout);
      worker->ensemble = std::make_unique<Ensemble>(worker->layout, movables_, rugs_);
    }
  }

  // The layout is empty, or else filled again in the end.
  void start_anew(Worker& worker, ChainState& state) const {
    const bool filled = !worker.layout.objects().empty();
    worker.layout.clear();
    state.random = state.random.fork("start");
    if (auto poses = another_start(worker.layout, start_, state.random, options_.solve.cancel))
      state.poses = *std::move(poses), state.local.clear();
    if (filled) fill(worker.layout);
  }

  void fill(Layout& layout) const {
    for (const auto& task : start_.tasks) layout.add(task.object);
  }

  void draw(std::size_t count) {
    for_each_chain([this, count](Worker& worker, std::size_t i) {
      ChainState& state = chains_[i].state;
      if (!begins(worker, state)) return;
      Chain chain(movables_, *worker.ensemble, state);
      for (std::size_t k = 0; k < count && !options_.solve.cancel.cancelled(); ++k) {
        walk(chain);
        chains_[i].drawn.push_back(measured(worker.scene, chain.poses()));
      }
    });
  }

  // Each time from nothing, if that leads to a layout that is right; else on from where the chain was, or from
  // what is varied.
  bool begins(Worker& worker, ChainState& state) const {
    ChainState before = state;
    if (samples_.drawn > 0) start_anew(worker, state);
    else before.poses = start_.poses;
    if (Chain(movables_, *worker.ensemble, state).stands()) return true;
    before.random = state.random;
    state = std::move(before);
    state.local.clear();
    return Chain(movables_, *worker.ensemble, state).stands();
  }

  void walk(Chain& chain) const {
    const int things = static_cast<int>(movables_.size());
    int left = static_cast<int>(steps_a_thing * things) + 1;
    for (int tries = most_tries_a_thing * things; left > 0 && tries > 0; --tries)
      if (chain.step()) --left;
  }

  SampledLayout measured(Scene& scene, const Poses& poses) const {
    SampledLayout layout{poses};
    scene = with_layout(std::move(scene), layout);
    for (const auto& verdict : judge_scene(scene, kinds_)) {
      layout.held += verdict.judgement.held ? 1 : 0;
      layout.score += verdict.judgement.degree / samples_.constraints;
    }
    return layout;
  }

  void gather(DistinctLayouts& distinct) {
    for (auto& chain : chains_) {
      for (auto& layout : chain.drawn) {
        if (samples_.layouts.size() == options_.count) break;
        ++samples_.drawn;
        if (distinct.add(layout.poses)) samples_.layouts.push_back(std::move(layout));
      }
      chain.drawn.clear();
    }
  }

  const KindTable& kinds_;
  const SampleOptions options_;
  const RugRule rugs_;
  Start start_;
  Samples samples_;
  std::vector<Movable> movables_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<ChainRun> chains_;
};

}  // namespace

Result<Samples> sample(const Scene& scene, const ModelTable& models, const KindTable& kinds,
                       const SampleOptions& options) {
  if (!scene.rooms.empty())
    return Error{Error::Kind::invalid_input, "a dwelling of several rooms cannot be varied; give one room"};
  auto ordered = in_placement_order(scene);
  if (!ordered) return ordered.error();
  const auto& objects = ordered->objects;
  if (auto sound = check_amount(objects.size(), options.count); !sound) return sound.error();
  return Sampler(*ordered, count_constraints(objects), RugRule(objects, models), models, kinds, options).run();
}

Result<Samples> sample(const Problem& problem, const ModelTable& models, const KindTable& kinds,
                       const SampleOptions& options) {
  if (auto sound = check_amount(problem.tasks.size(), options.count); !sound) return sound.error();
  auto solution = solve(problem, models, kinds, options.solve);
  if (!solution) return solution.error();
  return Sampler(solution->scene, solution->constraints, RugRule(), models, kinds, options).run();
}

}  // namespace roomgen
