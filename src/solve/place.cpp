#include "place.h"

#include <algorithm>
#include <limits>

#include "exact_choice.h"
#include "fuse.h"
#include "proposals.h"
#include "quality.h"
#include "refusal.h"
#include "score.h"

namespace roomgen {

namespace {

// What one rank at the top is worth of the fused sum.
constexpr double rank_at_top = 5e-5;
// And a metre off somebody's word: a centimetre is worth another look at what was put off.
constexpr double word_merit = 5e-3;

// The poses that pass the cheap tests, with their scores. Without a suggestion the constraints come
// first, and a pose that loses more of them than another is dropped as soon as that is known.
void score_feasible(const ProposalContext& context, const Layout::Candidate& candidate,
                    const std::vector<Pose>& poses, const PlaceOptions& options,
                    std::vector<Scored>& scored) {
  const FootprintAt footprint_at(context.task.object);
  int most_lost = std::numeric_limits<int>::max();
  for (const auto& pose : poses) {
    if (options.cancel.cancelled()) return;
    if (is_excepted(context.task.object, pose, options)) continue;
    const Footprint footprint = footprint_at(pose);
    if (!context.layout.fits(candidate, footprint, pose.bottom)) continue;
    if (options.accepts && !options.accepts(pose)) continue;
    const auto terms = score_relations(context, footprint, pose.bottom, most_lost);
    if (!terms) continue;
    scored.push_back({pose, *terms, 0.0});
    // One more may be lost, so that something is left should the best fail the exact tests.
    if (!context.suggestion.location) most_lost = std::min(most_lost, terms->lost + 1);
  }
}

bool one_holds_all(const std::vector<Scored>& scored) {
  return std::any_of(scored.begin(), scored.end(),
                     [](const Scored& s) { return s.terms.lost == 0; });
}

// Without a suggestion the number of lost constraints comes first, and the dearer terms are only
// asked of those that can win.
void add_general_terms(const ProposalContext& context, std::vector<Scored>& scored) {
  int least = std::numeric_limits<int>::max();
  for (const auto& s : scored) least = std::min(least, s.terms.lost);
  const FootprintAt footprint_at(context.task.object);
  for (auto& s : scored)
    if (context.suggestion.location || s.terms.lost == least)
      add_general_terms(context, footprint_at(s.pose), s.pose.bottom, s.terms);
}

std::vector<std::size_t> rank(const ProposalContext& context, std::vector<Scored>& scored,
                              const PlaceOptions& options, Random& random) {
  const auto& location = context.suggestion.location;
  add_general_terms(context, scored);
  std::vector<Ranked> ranked;
  ranked.reserve(scored.size());
  for (const auto& s : scored) {
    const double noise = options.noise > 0.0 ? options.noise * random.uniform() : 0.0;
    ranked.push_back({s.pose.position, s.terms.lost, total_degree(s.terms, context.layout.weights()) + noise});
  }
  fuse(ranked, location, options.fusion);
  for (std::size_t i = 0; i < scored.size(); ++i) {
    scored[i].terms.rank_c = ranked[i].rank_c;
    scored[i].terms.rank_l = location ? ranked[i].rank_l : 0.0;
    scored[i].terms.fused = scored[i].merit = ranked[i].fused;
    if (!options.fusion.ordinal_ranks) scored[i].merit -= word_merit * scored[i].terms.off;
  }
  return order_of_choice(ranked);
}

int count_around(const PlacementTask& task, std::span<const Object> placed,
                 std::span<const PlacementTask> later) {
  int count = count_around(task.object, placed);
  for (const auto& other : later) count += count_around(task.object, {&other.object, 1}) - 1;
  return count;
}

// Places a task by the cheap tests alone where all its constraints hold, if it can.
bool place_roughly(Layout& layout, const PlacementTask& task,
                   std::span<const PlacementTask> later) {
  auto relations = resolve(task.object, layout.room(), layout.objects(), layout.categories());
  // What waits for a target of its own cannot be judged yet.
  std::erase_if(relations, [](const ResolvedRelation& r) { return r.targets.empty(); });
  const auto context =
      make_context(layout, task, std::move(relations), count_around(task, layout.objects(), later));
  const auto candidate = layout.candidate(task.object);
  const FootprintAt footprint_at(task.object);
  std::optional<Pose> best;
  double best_degree = 0.0;
  for (const auto& pose : propose_exact(context)) {
    const Footprint area = footprint_at(pose);
    if (!layout.fits(candidate, area, pose.bottom)) continue;
    if (!holds_all(context, area, pose.bottom)) continue;
    const double degree = total_degree(score(context, area, pose.bottom), layout.weights());
    if (!best || degree > best_degree) best = pose, best_degree = degree;
  }
  if (best) layout.add(at_pose(task.object, *best));
  return best.has_value();
}

// How many of the tasks that depend on an object just added, directly or through each other, do not
// find a place that holds all their constraints. The layout is left as it was. Counts no further
// than `limit`.
int count_homeless(Layout& layout, const std::string& id, std::span<const PlacementTask> later,
                   int limit) {
  int homeless = 0;
  std::vector<std::string> family = {id};
  for (const auto& task : later) {
    const bool related = std::any_of(family.begin(), family.end(), [&](const std::string& member) {
      return depends_on(task.object, member);
    });
    if (!related) continue;
    if (homeless >= limit) break;
    if (place_roughly(layout, task, later))
      family.push_back(task.object.id);
    else
      ++homeless;
  }
  for (std::size_t i = 1; i < family.size(); ++i) layout.remove(family[i]);
  return homeless;
}

// The first candidate that passes; when others depend on the object, of the first few that pass the
// one that costs the fewest constraints, its own and those of dependants without a place.
std::optional<std::size_t> choose(Layout& layout, const PlacementTask& task,
                                  std::span<const PlacementTask> later,
                                  const std::vector<Scored>& scored,
                                  const std::vector<std::size_t>& order,
                                  const PlaceOptions& options) {
  ExactChoice chooser(layout, task, scored, order, rank_at_top, options);
  const auto first = chooser.next();
  const bool has_dependants = std::any_of(
      later.begin(), later.end(),
      [&](const PlacementTask& other) { return depends_on(other.object, task.object.id); });
  if (!first || !has_dependants) return first;
  std::optional<std::size_t> best;
  int best_cost = 0;
  int tried = 0;
  for (auto i = first; i; i = chooser.next()) {
    layout.add(at_pose(task.object, scored[*i].pose));
    const int lost = scored[*i].terms.lost;
    const int limit = best ? std::max(0, best_cost - lost) : std::numeric_limits<int>::max();
    const int cost = lost + count_homeless(layout, task.object.id, later, limit);
    layout.remove(task.object.id);
    if (!best || cost < best_cost) best = i, best_cost = cost;
    if (cost <= scored[*first].terms.lost || ++tried >= options.lookahead) break;
  }
  return best;
}

// The grid is looked at coarsely first, so that the choice of a neighbourhood does not depend on
// the pitch that was asked for.
constexpr double coarse_pitch = 0.20;
// What is farther off a suggested location may as well be turned, metres.
constexpr double far_off = 0.9;
// Metres about the suggested location that are looked at first.
constexpr double about_suggestion = 2.0;

std::vector<ResolvedRelation> resolved(const Layout& layout, const PlacementTask& task,
                                       const PlaceOptions& options) {
  auto relations = resolve(task.object, layout.room(), layout.objects(), layout.categories());
  for (auto& relation : relations) relation.least_gap = options.least_near;
  return relations;
}

// One object's way to its pose: from the poses that mean something over those near the suggestion
// to all of the grid, each step only if the one before does not settle it.
class Placing {
 public:
  Placing(Layout& layout, const PlacementTask& task, std::span<const PlacementTask> later,
          const PlaceOptions& options, Random& random)
      : layout_(layout),
        task_(task),
        later_(later),
        options_(options),
        random_(random),
        context_(
            make_context(layout, task, resolved(layout, task, options),
                         count_around(task, layout.objects(), later))),
        candidate_(layout.candidate(task)) {}

  Result<Placement> run() {
    if (stands_as_said()) return placement();
    // Of what was said the facing gives way to wishes alone, and to the place.
    faces_as_said_ = is_word() && context_.suggestion.facing;
    auto faced = search();
    if (!faces_as_said_ || (faced && wishes_lost(*faced) == 0 && faced->terms.off <= far_off))
      return faced;
    faces_as_said_ = false;
    auto turned = search();
    const auto loss = [&](const Placement& one) {
      return std::pair(wishes_lost(one), one.terms.off);
    };
    return faced && (!turned || loss(*faced) <= loss(*turned)) ? std::move(faced)
                                                               : std::move(turned);
  }

 private:
  // A suggestion of somebody's, which is not weighed as the paper has it.
  bool is_word() const { return context_.suggestion.binds && !options_.fusion.ordinal_ranks; }

  void let_meshes_decide(bool do_so) {
    candidate_.by_meshes = do_so;
    for (auto& companion : candidate_.companions) companion.self.by_meshes = do_so;
  }

  // Where the word says, at the wall that it means.
  std::vector<Pose> just_as_said() const {
    constexpr double nearly = 0.25;
    const Suggestion& said = context_.suggestion;
    std::vector<Pose> poses;
    if (task_.object.mount != Mount::wall) {
      std::vector<double> yaws = useful_yaws(context_);
      yaws =
          said.facing ? std::vector{*said.facing} : suggested_yaws(context_, *said.location, yaws);
      for (const double yaw : yaws)
        poses.push_back({*said.location, mounting_height(context_), yaw});
    } else if (said.facing) {
      propose_at_walls(context_, poses);
      const auto off = [&](const Pose& one) {
        return (one.position - *said.location).norm() +
               std::abs(wrap_angle(one.yaw - *said.facing));
      };
      std::sort(poses.begin(), poses.end(), [&](auto& a, auto& b) { return off(a) < off(b); });
      poses.resize(!poses.empty() && off(poses.front()) < nearly ? 1 : 0);
    }
    return poses;
  }

  // Nothing is nearer to a word than what it says.
  bool stands_as_said() {
    if (!is_word() || !location() || options_.grid == GridUse::only ||
        task_.object.mount == Mount::surface)
      return false;
    let_meshes_decide(true);
    add(just_as_said());
    let_meshes_decide(false);
    std::erase_if(scored_, [](const Scored& one) { return one.terms.lost > 0; });
    if (!scored_.empty()) decide();
    return best_.has_value();
  }

  int wishes_lost(const Placement& placed) const {
    const auto wishes =
        std::min(static_cast<std::size_t>(task_.wishes), context_.relations.size());
    return task_.wishes - count_held(std::span(context_.relations).first(wishes), placed.object,
                                     layout_.room());
  }

  Result<Placement> search() {
    scored_.clear(), best_.reset(), proposed_ = 0;
    // Where there is no grid, meaningful poses are all there is.
    if (options_.grid != GridUse::only || task_.object.mount != Mount::floor)
      add(propose_exact(context_));
    meaningful_ = scored_.size();
    if (!scored_.empty() && (meaningful_poses_are_enough() || context_.suggestion.binds)) decide();
    if (options_.grid == GridUse::near_suggestions && may_be_followed_better()) best_.reset();
    if (!best_ && options_.grid != GridUse::never) look_at_grid();
    if (options_.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
    if (!best_) return refusal(layout_, task_, candidate_, proposed_, static_cast<int>(scored_.size()));
    return placement();
  }

  // Without a suggestion, a meaningful pose that holds everything needs no grid beside it, and no
  // grid point is flush with a wall.
  bool meaningful_poses_are_enough() const {
    if (options_.grid == GridUse::never) return true;
    if (options_.grid == GridUse::only) return task_.object.mount != Mount::floor;
    if (options_.grid == GridUse::near_suggestions && location()) return false;
    return one_holds_all(scored_) || wants(context_, RelationKind::edge) ||
           wants(context_, RelationKind::corner);
  }

  const std::optional<Vec2>& location() const { return context_.suggestion.location; }

  // Of a designer's word. Where it is followed and everything holds, no grid point does better.
  bool may_be_followed_better() const {
    if (!best_ || !context_.suggestion.binds) return false;
    const Scored& best = scored_[*best_];
    return options_.fusion.ordinal_ranks || best.terms.lost > 0 ||
           !follows(task_.object, best.pose, context_.suggestion);
  }

  void look_at_grid() {
    // Without a suggestion the meaningful poses are the fine ones.
    const double pitch = location() && options_.fusion.ordinal_ranks
                             ? options_.pitch
                             : std::max(coarse_pitch, options_.pitch);
    if (near_suggestion_may_be_enough()) {
      decide_with(propose_grid(context_, pitch, Disc{*location(), about_suggestion}));
      if (best_ && scored_[*best_].terms.lost > 0) best_.reset();
    }
    if (!best_) decide_with(propose_grid(context_, pitch));
    if (best_ && location() && options_.pitch < pitch) refine();
  }

  // Where everything holds near the suggestion, nothing farther away has a higher sum.
  bool near_suggestion_may_be_enough() const {
    return location() && !options_.fusion.ordinal_ranks && options_.fusion.alpha < 1.0;
  }

  // A suggestion is followed closely: once more about the choice, as finely as was asked.
  void refine() {
    const Disc part{scored_[*best_].pose.position, coarse_pitch};
    const auto coarse = scored_[*best_];
    add(propose_grid(context_, options_.pitch, part));
    decide(part);
    if (!best_) scored_.push_back(coarse), best_ = scored_.size() - 1;
  }

  void add(std::vector<Pose> poses) {
    if (faces_as_said_)
      std::erase_if(poses, [&](const Pose& pose) {
        return !follows(task_.object, pose, {{}, context_.suggestion.facing});
      });
    proposed_ += static_cast<int>(poses.size());
    score_feasible(context_, candidate_, poses, options_, scored_);
  }

  void decide(const std::optional<Disc>& part = std::nullopt) {
    order_ = rank(context_, scored_, options_, random_);
    if (part)
      std::erase_if(order_, [&](std::size_t i) {
        return (scored_[i].pose.position - part->center).norm() > part->radius + 1e-9;
      });
    best_ = choose(layout_, task_, later_, scored_, order_, options_);
  }

  void decide_with(const std::vector<Pose>& grid) {
    scored_.resize(meaningful_);
    add(grid);
    decide();
  }

  Placement placement() const {
    Placement placement;
    placement.object = at_pose(task_.object, scored_[*best_].pose);
    placement.terms = scored_[*best_].terms;
    if (order_.size() > 1)
      placement.runner_up = scored_[order_[0] == *best_ ? order_[1] : order_[0]].terms;
    placement.candidates = proposed_;
    placement.feasible = static_cast<int>(scored_.size());
    return placement;
  }

  Layout& layout_;
  const PlacementTask& task_;
  std::span<const PlacementTask> later_;
  const PlaceOptions& options_;
  Random& random_;
  ProposalContext context_;
  Layout::Candidate candidate_;
  std::vector<Scored> scored_;
  std::size_t meaningful_ = 0;  ///< the first of scored_ that are no grid points
  std::vector<std::size_t> order_;
  std::optional<std::size_t> best_;
  bool faces_as_said_ = false;  ///< other poses are left out
  int proposed_ = 0;
};

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
  if (!layout.has_way_in() && needs_way_in(layout, task)) return no_way_in(task);
  if (task.usual && !task.location && task.object.mount != Mount::surface)
    if (const Arrangement* arrangement = layout.arrangement_of(task))
      return place_usually(layout, task, *arrangement, options, random);
  return Placing(layout, task, later, options, random).run();
}

}  // namespace roomgen
