#include <algorithm>
#include <cmath>
#include <limits>

#include "compatible.h"
#include "exact_choice.h"
#include "fuse.h"
#include "place.h"
#include "propose.h"
#include "refusal.h"
#include "score.h"
#include "ways.h"

namespace roomgen {

namespace {

constexpr double grid_pitch = 0.20;
// Large rooms have no more points than this across.
constexpr double most_across = 30.0;
// A difference in preference that is worth another look at what was put off.
constexpr double clearly_better = 0.5;

double habit_weight(const Weights& weights, std::size_t i) {
  return weights.first_habit -
         weights.habit_step * std::min(static_cast<double>(i), weights.most_steps);
}

/// One way with its targets named: what is asked and the habits that do not contradict it.
struct Choice {
  PlacementTask task;  ///< its relations are those asked and then the habits
  std::size_t asked = 0;
  double burden = 0.0;
};

/// What is known of a Scored beside it.
struct Origin {
  std::size_t choice = 0;
  std::vector<bool> held;  ///< relations of the choice's task
  bool leads = false;      ///< the first habit holds
};

class UsualPlacing {
 public:
  UsualPlacing(Layout& layout, const PlacementTask& task, const Arrangement& arrangement,
               const PlaceOptions& options, Random& random)
      : layout_(layout),
        task_(task),
        arrangement_(arrangement),
        options_(options),
        random_(random),
        candidate_(layout.candidate(task)) {}

  Result<Placement> run() {
    std::optional<Placement> fallback;
    for (const auto& way : ways()) {
      auto [placement, leads] = place_by(way);
      if (options_.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
      if (placement && leads) return *std::move(placement);
      if (placement && task_.anywhere && (!fallback || is_better(*placement, *fallback)))
        fallback = std::move(placement);
    }
    if (fallback) return *std::move(fallback);
    return refusal(layout_, task_, candidate_, proposed_, feasible_);
  }

 private:
  std::vector<std::vector<Relation>> ways() const {
    auto ways = arrangement_.ways;
    if (task_.anywhere)
      ways.insert(ways.end(), arrangement_.otherwise.begin(), arrangement_.otherwise.end());
    if (ways.empty()) ways.emplace_back();
    return ways;
  }

  bool is_better(const Placement& a, const Placement& b) const {
    if (a.terms.lost != b.terms.lost) return a.terms.lost < b.terms.lost;
    return total_degree(a.terms, layout_.weights()) > total_degree(b.terms, layout_.weights());
  }

  // The best place for one way, whichever things its targets are, and whether its leading habit holds.
  std::pair<std::optional<Placement>, bool> place_by(const std::vector<Relation>& way) {
    choices_.clear(), scored_.clear(), origins_.clear();
    for (auto& named : name_targets(layout_, task_.object, way)) choices_.push_back(choice_of(named));
    for (std::size_t i = 0; i < choices_.size(); ++i) consider(i);
    feasible_ += static_cast<int>(scored_.size());
    const auto order = rank();
    ExactChoice choice(layout_, task_, scored_, order, clearly_better, options_);
    const auto best = choice.next();
    if (!best) return {};
    return {placement_at(*best, order), origins_[*best].leads};
  }

  Choice choice_of(const NamedWay& way) const {
    Choice choice{task_, task_.object.relations.size(), way.burden};
    auto& relations = choice.task.object.relations;
    for (auto& habit : compatible_with(task_.object.relations, way.relations))
      relations.push_back(std::move(habit));
    choice.task.wishes = static_cast<int>(choice.asked);
    return choice;
  }

  // Judges all poses of a choice; what its kind prefers is only asked of those that can win.
  void consider(std::size_t index) {
    const Choice& choice = choices_[index];
    const auto context = make_context(
        layout_, choice.task,
        resolve(choice.task.object, layout_.room(), layout_.objects(), layout_.categories()),
        count_around(choice.task.object, layout_.objects()));
    auto poses = propose_exact(context);
    if (may_stand_anywhere(choice.task.object.relations)) {
      const double across = std::sqrt(area(layout_.room().polygon));
      const auto grid = propose_grid(context, std::max(grid_pitch, across / most_across));
      poses.insert(poses.end(), grid.begin(), grid.end());
    }
    proposed_ += static_cast<int>(poses.size());
    const std::size_t first = scored_.size();
    const FootprintAt footprint_at(task_.object);
    for (const auto& pose : poses) {
      if (options_.cancel.cancelled()) return;
      if (is_excepted(task_.object, pose, options_)) continue;
      const Footprint footprint = footprint_at(pose);
      if (!layout_.fits(candidate_, footprint, pose.bottom)) continue;
      if (options_.accepts && !options_.accepts(pose)) continue;
      judge_all(context, index, pose, footprint);
    }
    add_preferences(context, footprint_at, first);
  }

  // What only belongs somewhere in the room, and not at its walls.
  bool may_stand_anywhere(const std::vector<Relation>& relations) const {
    const bool keeps_to_walls = std::any_of(
        arrangement_.preferences.begin(), arrangement_.preferences.end(), [](const auto& one) {
          return one.what == Preference::wall_near && one.weight >= 1.0;
        });
    return task_.object.mount == Mount::floor && !keeps_to_walls &&
           std::none_of(relations.begin(), relations.end(), [](const Relation& relation) {
             switch (relation.kind) {
               case RelationKind::edge:
               case RelationKind::corner:
                 return true;
               case RelationKind::in_part:
               case RelationKind::far:
               case RelationKind::gap:
               case RelationKind::face_to:
               case RelationKind::used_facing:
                 return false;
               default:
                 return !relation.target.empty();
             }
           });
  }

  void judge_all(const ProposalContext& context, std::size_t index, const Pose& pose,
                 const Footprint& footprint) {
    const Choice& choice = choices_[index];
    const Subject subject{footprint, pose.bottom, pose.bottom + task_.object.size.z()};
    Scored one{pose, {}, 0.0};
    Origin origin{index, {}, context.relations.size() == choice.asked};
    for (std::size_t i = 0; i < context.relations.size(); ++i) {
      const bool is_habit = i >= choice.asked;
      const Judgement judgement = judge(context.relations[i], subject, layout_.room());
      origin.held.push_back(judgement.held);
      if (judgement.held) {
        ++one.terms.held;
        one.terms.relations += judgement.degree;
        if (is_habit) one.terms.arrangement += habit_weight(layout_.weights(), i - choice.asked);
        if (i == choice.asked) origin.leads = true;
      } else if (!is_habit) {
        ++one.terms.lost;
      }
    }
    one.terms.relations /= static_cast<double>(std::max(1, one.terms.held + one.terms.lost));
    one.terms.arrangement -= layout_.weights().burden * choice.burden;
    scored_.push_back(one);
    origins_.push_back(std::move(origin));
  }

  void add_preferences(const ProposalContext& context, const FootprintAt& footprint_at,
                       std::size_t first) {
    int least = std::numeric_limits<int>::max();
    for (const auto& one : scored_) least = std::min(least, one.terms.lost);
    double most = std::numeric_limits<double>::lowest();
    for (const auto& one : scored_)
      if (one.terms.lost == least) most = std::max(most, one.terms.arrangement);
    for (std::size_t i = first; i < scored_.size(); ++i) {
      auto& terms = scored_[i].terms;
      if (terms.lost > least || terms.arrangement < most - layout_.weights().most_preference) continue;
      add_general_terms(context, footprint_at(scored_[i].pose), scored_[i].pose.bottom, terms);
      if (task_.location)
        terms.arrangement += layout_.weights().plan_location /
                             (1.0 + (*task_.location - scored_[i].pose.position).norm());
    }
  }

  // Fewest lost first, then what is preferred.
  std::vector<std::size_t> rank() {
    std::vector<Ranked> ranked;
    for (auto& one : scored_) {
      const double noise = options_.noise > 0.0 ? options_.noise * random_.uniform() : 0.0;
      one.merit = total_degree(one.terms, layout_.weights()) + noise;
      ranked.push_back({one.pose.position, one.terms.lost, one.merit});
    }
    fuse(ranked, std::nullopt, options_.fusion);
    for (std::size_t i = 0; i < scored_.size(); ++i) {
      scored_[i].terms.rank_c = ranked[i].rank_c;
      scored_[i].terms.fused = ranked[i].fused;
    }
    return order_of_choice(ranked);
  }

  Placement placement_at(std::size_t best, const std::vector<std::size_t>& order) const {
    Placement placement;
    placement.object = at_pose(task_.object, scored_[best].pose);
    const Origin& origin = origins_[best];
    const Choice& choice = choices_[origin.choice];
    placement.object.relations = task_.object.relations;
    for (std::size_t i = choice.asked; i < origin.held.size(); ++i)
      if (origin.held[i])
        placement.object.relations.push_back(choice.task.object.relations[i]);
    placement.terms = scored_[best].terms;
    if (order.size() > 1)
      placement.runner_up = scored_[order[0] == best ? order[1] : order[0]].terms;
    placement.candidates = proposed_;
    placement.feasible = feasible_;
    return placement;
  }

  Layout& layout_;
  const PlacementTask& task_;
  const Arrangement& arrangement_;
  const PlaceOptions& options_;
  Random& random_;
  Layout::Candidate candidate_;
  std::vector<Choice> choices_;
  std::vector<Scored> scored_;
  std::vector<Origin> origins_;  ///< parallel to scored_
  int proposed_ = 0, feasible_ = 0;
};

}  // namespace

Result<Placement> place_usually(Layout& layout, const PlacementTask& task,
                                const Arrangement& arrangement, const PlaceOptions& options,
                                Random& random) {
  return UsualPlacing(layout, task, arrangement, options, random).run();
}

PlacementTask with_leading_habit(const Layout& layout, PlacementTask task) {
  const Arrangement* arrangement = task.usual ? layout.arrangement_of(task) : nullptr;
  task.usual = false;
  if (!arrangement || task.object.mount == Mount::surface) return task;
  auto& relations = task.object.relations;
  for (const auto& way : arrangement->ways) {
    const auto named = name_targets(layout, task.object, way);
    if (named.empty()) continue;
    const auto habits = compatible_with(relations, named.front().relations);
    if (!habits.empty()) relations.push_back(habits.front());
    break;
  }
  return task;
}

}  // namespace roomgen
