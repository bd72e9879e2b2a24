#include "roomgen/solve/place.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "propose.h"
#include "roomgen/base/text.h"
#include "score.h"

namespace roomgen {

namespace {

struct Scored {
  Pose pose;
  PlacementTerms terms;
};

// The poses that pass the cheap tests, with their scores.
void score_feasible(const ProposalContext& context, const Layout::Candidate& candidate,
                    const std::vector<Pose>& poses, std::vector<Scored>& scored) {
  const Object& object = context.task.object;
  for (const auto& pose : poses) {
    const Footprint footprint(pose.position, object.size.head<2>(), pose.yaw, object.traits.round);
    if (!context.layout.fits(candidate, footprint, pose.bottom)) continue;
    scored.push_back({pose, score(context, footprint, pose.bottom)});
  }
}

bool one_holds_all(const std::vector<Scored>& scored) {
  return std::any_of(scored.begin(), scored.end(),
                     [](const Scored& s) { return s.terms.lost == 0; });
}

std::vector<std::size_t> rank(std::vector<Scored>& scored, const PlacementTask& task,
                              const PlaceOptions& options, Random& random) {
  std::vector<Ranked> ranked;
  ranked.reserve(scored.size());
  for (const auto& s : scored) {
    const double noise = options.noise > 0.0 ? options.noise * random.uniform() : 0.0;
    ranked.push_back({s.pose.position, s.terms.lost, total_degree(s.terms) + noise});
  }
  fuse(ranked, task.location, options.fusion);
  for (std::size_t i = 0; i < scored.size(); ++i) {
    scored[i].terms.rank_c = ranked[i].rank_c;
    scored[i].terms.rank_l = task.location ? ranked[i].rank_l : 0.0;
    scored[i].terms.fused = ranked[i].fused;
  }
  return order_of_choice(ranked);
}

int count_around(const PlacementTask& task, std::span<const Object> placed,
                 std::span<const PlacementTask> later) {
  const auto target = std::find_if(
      task.object.relations.begin(), task.object.relations.end(),
      [](const Relation& relation) { return relation.kind == RelationKind::around; });
  if (target == task.object.relations.end()) return 1;
  const auto is_around = [&](const Object& object) {
    return std::find(object.relations.begin(), object.relations.end(), *target) !=
           object.relations.end();
  };
  return 1 + static_cast<int>(std::count_if(placed.begin(), placed.end(), is_around)) +
         static_cast<int>(std::count_if(later.begin(), later.end(), [&](const PlacementTask& t) {
           return is_around(t.object);
         }));
}

bool depends_on(const Object& object, const std::string& id) {
  return object.on == id ||
         std::any_of(object.relations.begin(), object.relations.end(),
                     [&](const Relation& relation) { return relation.target == id; });
}

// Tries, by the cheap tests alone, to place the tasks that depend on an object just added; returns how
// many do not find a place that holds all their constraints. The layout is left as it was.
int count_homeless(Layout& layout, const std::string& id, std::span<const PlacementTask> later) {
  int homeless = 0;
  std::vector<std::string> added;
  for (const auto& task : later) {
    if (!depends_on(task.object, id)) continue;
    auto relations = resolve(task.object, layout.room(), layout.objects(), layout.categories());
    // What waits for a target of its own cannot be judged yet.
    std::erase_if(relations, [](const ResolvedRelation& r) { return r.targets.empty(); });
    const int around = count_around(task, layout.objects(), later);
    const ProposalContext context{layout, task, relations, around};
    const auto candidate = layout.candidate(task.object);
    bool found = false;
    for (const auto& pose : propose_exact(context)) {
      const Footprint area(pose.position, task.object.size.head<2>(), pose.yaw,
                           task.object.traits.round);
      if (!layout.fits(candidate, area, pose.bottom)) continue;
      if (!holds_all(context, area, pose.bottom)) continue;
      added.push_back(task.object.id);
      layout.add(at_pose(task.object, pose));
      found = true;
      break;
    }
    if (!found) ++homeless;
  }
  for (const auto& other : added) layout.remove(other);
  return homeless;
}

std::string size_text(const Vec3& size) {
  return format_number(size.x(), 2) + " x " + format_number(size.y(), 2) + " x " +
         format_number(size.z(), 2) + " m";
}

Error refusal(const PlacementTask& task, int candidates, int feasible) {
  std::string why = "no place for " + task.object.id + " (" + size_text(task.object.size) + "): ";
  if (feasible == 0)
    why += "none of " + std::to_string(candidates) +
           " positions is inside the room and clear of doors, windows and other things";
  else
    why += "each of the " + std::to_string(feasible) +
           " clear positions would leave something unusable or out of reach";
  return {Error::Kind::not_found, why};
}

// Tests candidates in the order of choice until one stands up to the exact tests. Near a candidate that
// failed, others will probably fail too: they are tried after those elsewhere.
class Chooser {
 public:
  Chooser(Layout& layout, const PlacementTask& task, const std::vector<Scored>& scored,
          const PlaceOptions& options)
      : layout_(layout), task_(task), scored_(scored), options_(options) {}

  /// Indices of candidates that pass, at most `wanted`, in the order of choice.
  std::vector<std::size_t> choose(const std::vector<std::size_t>& order, int wanted) {
    std::vector<std::size_t> passed, deferred;
    for (std::size_t i : order) {
      if (static_cast<int>(passed.size()) >= wanted || tests_ >= options_.max_exact_tests) break;
      // Worse by whole constraints: no need to look further once something passed.
      if (!passed.empty() && scored_[i].terms.lost > scored_[passed.front()].terms.lost &&
          !task_.location)
        break;
      if (failures_near(i) >= 2 || is_like_one_of(passed, i)) {
        deferred.push_back(i);
        continue;
      }
      test(i, passed);
    }
    for (std::size_t i : deferred) {
      if (!passed.empty() || tests_ >= options_.max_exact_tests) break;
      test(i, passed);
    }
    return passed;
  }

 private:
  static constexpr double neighbourhood = 0.25;
  static constexpr double alternative_distance = 0.6;

  std::pair<int, int> cell(std::size_t i) const {
    const Vec2 index = (scored_[i].pose.position / neighbourhood).array().floor();
    return {static_cast<int>(index.x()), static_cast<int>(index.y())};
  }
  // Alternatives are worth looking at when they differ.
  bool is_like_one_of(const std::vector<std::size_t>& passed, std::size_t i) const {
    const Pose& pose = scored_[i].pose;
    return std::any_of(passed.begin(), passed.end(), [&](std::size_t j) {
      const Pose& other = scored_[j].pose;
      return (pose.position - other.position).norm() < alternative_distance &&
             std::abs(wrap_angle(pose.yaw - other.yaw)) < 0.1;
    });
  }
  int failures_near(std::size_t i) const {
    const auto found = failures_.find(cell(i));
    return found == failures_.end() ? 0 : found->second;
  }
  void test(std::size_t i, std::vector<std::size_t>& passed) {
    ++tests_;
    const auto candidate = layout_.candidate(at_pose(task_.object, scored_[i].pose));
    if (layout_.fits_exactly(candidate)) passed.push_back(i);
    else ++failures_[cell(i)];
  }

  Layout& layout_;
  const PlacementTask& task_;
  const std::vector<Scored>& scored_;
  const PlaceOptions& options_;
  std::map<std::pair<int, int>, int> failures_;
  int tests_ = 0;
};

// Of the candidates that passed, the one that leaves the fewest dependants without a place.
std::size_t kindest(Layout& layout, const PlacementTask& task, std::span<const PlacementTask> later,
                    const std::vector<Scored>& scored, const std::vector<std::size_t>& passed) {
  std::size_t best = passed.front();
  int best_homeless = 1 << 20;
  for (std::size_t i : passed) {
    layout.add(at_pose(task.object, scored[i].pose));
    const int homeless = count_homeless(layout, task.object.id, later) + scored[i].terms.lost;
    layout.remove(task.object.id);
    if (homeless < best_homeless) best = i, best_homeless = homeless;
    if (homeless == scored[passed.front()].terms.lost) break;
  }
  return best;
}

}  // namespace

Status PlaceOptions::validate() const {
  const auto error = [](const std::string& what) {
    return Error{Error::Kind::invalid_input, what};
  };
  if (!(fusion.alpha >= 0 && fusion.alpha <= 1)) return error("alpha must be between 0 and 1");
  if (!(fusion.c >= 1)) return error("the fusion constant must be at least 1");
  if (!(pitch >= 0.02 && pitch <= 1)) return error("the pitch must be between 0.02 and 1 m");
  return {};
}

Result<Placement> place(Layout& layout, const PlacementTask& task,
                        std::span<const PlacementTask> later, const PlaceOptions& options,
                        Random& random) {
  const auto relations =
      resolve(task.object, layout.room(), layout.objects(), layout.categories());
  const int around = count_around(task, layout.objects(), later);
  const ProposalContext context{layout, task, relations, around};
  const auto candidate = layout.candidate(task.object);

  std::vector<Scored> scored;
  auto poses = propose_exact(context);
  auto proposed = static_cast<int>(poses.size());
  score_feasible(context, candidate, poses, scored);

  std::vector<std::size_t> passed;
  Chooser chooser(layout, task, scored, options);
  const bool has_dependants =
      std::any_of(later.begin(), later.end(),
                  [&](const PlacementTask& t) { return depends_on(t.object, task.object.id); });
  const int wanted = has_dependants ? options.lookahead : 2;
  // Without a suggestion, a meaningful pose that holds everything needs no grid beside it.
  const bool grid_needed = task.location.has_value() || !one_holds_all(scored);
  if (!grid_needed) passed = chooser.choose(rank(scored, task, options, random), wanted);
  if (passed.empty()) {
    poses = propose_grid(context, options.pitch);
    proposed += static_cast<int>(poses.size());
    score_feasible(context, candidate, poses, scored);
    passed = chooser.choose(rank(scored, task, options, random), wanted);
  }
  if (passed.empty()) return refusal(task, proposed, static_cast<int>(scored.size()));

  const std::size_t best =
      has_dependants ? kindest(layout, task, later, scored, passed) : passed.front();
  Placement placement;
  placement.object = at_pose(task.object, scored[best].pose);
  placement.terms = scored[best].terms;
  for (std::size_t i : passed)
    if (i != best) {
      placement.runner_up = scored[i].terms;
      break;
    }
  placement.candidates = proposed;
  placement.feasible = static_cast<int>(scored.size());
  return placement;
}

}  // namespace roomgen
