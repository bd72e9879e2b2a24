#include "anneal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomgen::lab::annealing {

namespace {

// Infinigen's schedule: from 3 to 0.001 over 85 % of the steps, then held.
constexpr double coldest = 0.001, cooling_share = 0.85;
// Metres by which things are shifted at last.
constexpr double narrowest = 0.02;
// Violations weigh this much against temperature: a step back is taken early and hardly ever late.
constexpr double violation_weight = 6.0;
// What a thing counts that cannot be used, at the beginning and at the end: then more than that it is missing.
constexpr double first_useless = 1.0, last_useless = 10.0;
constexpr double same = 1e-9;
constexpr double crowded = 0.25;  // share of the floor
constexpr std::size_t most_points = 400;
constexpr int steps_between_looks = 25;

// How often each move is tried, at the beginning and at the end (Infinigen's table; clusters after InfiniBench).
struct Share {
  double first, last;
};
constexpr std::array<Share, move_kinds> shares = {{
    {6.0, 0.6},   // add
    {1.5, 0.1},   // remove
    {1.0, 0.2},   // resample
    {1.5, 3.0},   // translate
    {0.6, 0.8},   // rotate
    {1.5, 0.4},   // change plane
    {0.6, 0.3},   // change target
    {0.4, 0.2},   // swap
    {0.6, 0.1},   // resample cluster
    {1.5, 1.5},   // translate cluster
    {1.0, 0.4},   // rotate cluster
}};

class Annealer {
 public:
  Annealer(World& world, Evaluator& evaluator, Moves& moves, Random& random, const AnnealOptions& options)
      : world_(world), evaluator_(evaluator), moves_(moves), random_(random), options_(options) {}

  AnnealResult run() {
    result_.worth.violation = std::numeric_limits<double>::infinity();
    current_ = evaluator_.worth();
    useless_ = world_.useless();
    keep_if_best(0);
    for (int step = 1; step <= options_.steps; ++step) {
      if (options_.cancel.cancelled()) {
        result_.is_cut = true;
        break;
      }
      try_one(step, static_cast<double>(step) / options_.steps);
      if (options_.on_progress && step % 1000 == 0)
        options_.on_progress(step, result_.worth, result_.best.size());
    }
    return std::move(result_);
  }

 private:
  MoveKind choose(double progress) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < move_kinds; ++i) {
      const bool cluster = i >= static_cast<std::size_t>(MoveKind::resample_cluster);
      const bool allowed = cluster ? options_.cluster_moves : options_.object_moves;
      weights.push_back(allowed ? shares[i].first + progress * (shares[i].last - shares[i].first) : 0.0);
    }
    return static_cast<MoveKind>(random_.weighted(weights));
  }

  // Useless things are what a room may pass through, but not end with: they count ever more.
  bool accepts(const Worth& next, int useless, double progress, double temperature) {
    const double each = first_useless + progress * (last_useless - first_useless);
    const double worse = next.violation - current_.violation + each * (useless - useless_);
    if (worse < -same) return true;
    if (worse > same) return random_.chance(std::exp(-violation_weight * worse / temperature));
    const double dearer = next.loss - current_.loss;
    return dearer <= 0.0 || random_.chance(std::exp(-dearer / temperature));
  }

  void try_one(int step, double progress) {
    const double cooled = std::min(1.0, progress / cooling_share);
    const double temperature = options_.hottest * std::pow(coldest / options_.hottest, cooled);
    const double reach = options_.widest * std::pow(narrowest / options_.widest, cooled);
    const MoveKind kind = choose(progress);
    ++result_.tried[static_cast<std::size_t>(kind)];
    world_.mark();
    const auto moved = moves_.propose(kind, reach);
    if (!moved || !world_.boxes_admit(*moved)) return world_.undo();
    const Worth next = evaluator_.worth();
    const int useless = world_.useless();
    if (!accepts(next, useless, progress, temperature) || !world_.meshes_admit()) return world_.undo();
    if (options_.always_usable && useless > 0) return world_.undo();
    if ((options_.always_usable || is_crowded()) && !world_.is_reachable()) return world_.undo();
    ++result_.accepted[static_cast<std::size_t>(kind)];
    current_ = next, useless_ = useless;
    keep_if_best(step);
  }

  // On a full floor nearly all that is better leaves somebody no way, and what is gone through would never lead back.
  bool is_crowded() { return evaluator_.occupancy() > crowded; }

  bool is_better() const {
    if (result_.curve.empty()) return true;
    if (std::abs(current_.violation - result_.worth.violation) > same)
      return current_.violation < result_.worth.violation;
    return current_.loss < result_.worth.loss - 1e-6;
  }

  // Whether people can walk everywhere is dear to say: of a stretch of small gains only some are looked at.
  void keep_if_best(int step) {
    if (!is_better()) return;
    const bool fewer = current_.violation < result_.worth.violation - same;
    if (!fewer && step < last_look_ + steps_between_looks && step < options_.steps) return;
    last_look_ = step;
    if (useless_ > 0 || !world_.is_reachable()) return;
    result_.worth = current_;
    result_.best.clear();
    world_.things().each([&](Slot slot) {
      result_.best.push_back({slot, world_.item(slot).article, world_.item(slot).stance});
    });
    if (result_.curve.size() < most_points) result_.curve.push_back({step, current_});
    else result_.curve.back() = {step, current_};
  }

  World& world_;
  Evaluator& evaluator_;
  Moves& moves_;
  Random& random_;
  const AnnealOptions& options_;
  Worth current_;
  int useless_ = 0;  ///< things of the current state without a free use zone
  int last_look_ = 0;
  AnnealResult result_;
};

}  // namespace

AnnealResult anneal(World& world, Evaluator& evaluator, Moves& moves, Random& random, const AnnealOptions& options) {
  return Annealer(world, evaluator, moves, random, options).run();
}

}  // namespace roomgen::lab::annealing
