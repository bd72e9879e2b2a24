#include "advise.h"

#include <algorithm>
#include <cmath>

#include "candidates.h"
#include "holding.h"
#include "likes.h"
#include "merge.h"
#include "on_top.h"
#include "reach.h"
#include "roomgen/base/text.h"
#include "targets.h"

namespace roomgen::design {

namespace {

// What counts more is decided by powers: one wish of the prompt outweighs all habits.
constexpr double asked_weight = 60.0;
constexpr double habit_weight = 6.0;
constexpr double habit_step = 0.5;
constexpr double burden_weight = 4.0;
constexpr double reserve_weight = 2.4;
constexpr double taken_weight = 1.2;
constexpr double sliver_weight = 0.15;
constexpr double gap_weight = 0.6;
constexpr double asked_gap_weight = 8.0;
constexpr double hint_weight = 3.0;
constexpr double crowded_weight = 1.5;
constexpr double middle_weight = 4.0;
constexpr double askew_weight = 8.0;  ///< a radian
constexpr double farthest_opposite = 3.5;  ///< metres
constexpr double comfort_range = 8.0;
// Another try after a refusal goes at least so far away.
constexpr double elsewhere = 0.6;
constexpr std::size_t max_walks = 60;

struct Option {
  Pose pose;
  double score = 0.0;
  bool leading = false;             ///< the most important relation holds
  std::vector<Relation> relations;  ///< that hold
};

/// One object whose place is sought.
struct Task {
  const Sketch& sketch;
  const Object& self;
  const Arrangement& arrangement;
  const std::vector<Relation>& asked;
  std::optional<Vec2> hint;  ///< the location that the plan gives
  double bottom = 0.0;
  int company = 1;     ///< how many of its kind will share a table
  bool needed = true;  ///< asked for or refused elsewhere: goes anywhere rather than nowhere
};

// 1 inside the range that the pair prefers, less with the distance to it.
double gap_degree(const Placed& placed, const ResolvedRelation& relation) {
  double degree = 0.0;
  for (const auto& target : relation.targets) {
    const double distance = gap(placed.footprint, target);
    const double off =
        std::max({0.0, relation.gap_low - distance, distance - relation.gap_high});
    degree = std::max(degree, 1.0 / (1.0 + 3.0 * off));
  }
  return degree;
}

// Between its front and the middle of the target, radians.
double angle_to(const Placed& placed, const Target& target) {
  const Vec2 towards = target.footprint.center() - placed.pose.position;
  return towards.norm() < 1e-9 ? 0.0
                               : std::abs(wrap_angle(yaw_facing(towards) - placed.pose.yaw));
}

// The middle of the room is a matter of degree, and what is opposite is not out of sight.
double asked_place_degree(const Task& task, const Placed& placed) {
  double score = 0.0;
  for (const auto& relation : task.asked) {
    if (relation.kind == RelationKind::middle)
      score += middle_weight * degree(task.sketch, placed, Liking::center);
    for (const auto& target : task.sketch.find(relation.target)) {
      if (relation.kind == RelationKind::far)
        score -= std::max(0.0, gap_to(placed, target) - farthest_opposite);
      if (relation.kind == RelationKind::face_to)
        score -= askew_weight * angle_to(placed, target);
    }
  }
  return score;
}

double comfort(const Task& task, const Placed& placed, const std::vector<Relation>& relations,
               const std::vector<ResolvedRelation>& resolved) {
  double score = 0.0;
  for (const auto& like : task.arrangement.likes)
    score += like.weight * degree(task.sketch, placed, like.liking);
  score += reserve_weight * reserve_open(task.sketch, placed, task.arrangement);
  if (!task.self.traits.flat && task.self.mount == Mount::floor) {
    score -= taken_weight * reserves_taken(task.sketch, placed, relations);
    score -= sliver_weight * slivers(task.sketch, placed, relations);
    if (!task.arrangement.seats && on_crowded_side(task.sketch, placed, relations))
      score -= crowded_weight;
  }
  for (std::size_t i = 0; i < resolved.size(); ++i)
    if (resolved[i].kind == RelationKind::near || resolved[i].kind == RelationKind::next_to ||
        resolved[i].kind == RelationKind::around)
      score += (i < task.asked.size() ? asked_gap_weight : gap_weight) *
               gap_degree(placed, resolved[i]);
  score += asked_place_degree(task, placed);
  if (task.hint) score += hint_weight / (1.0 + (*task.hint - placed.pose.position).norm());
  return score;
}

// `all` are those asked for, then the habits.
Option judge(const Task& task, const Pose& pose, const std::vector<Relation>& habits,
             const std::vector<ResolvedRelation>& all) {
  const Placed placed{&task.self, pose, footprint_at(task.self, pose), task.bottom};
  Option option{pose, pose.merit, true, {}};
  for (std::size_t i = 0; i < task.asked.size(); ++i) {
    option.relations.push_back(task.asked[i]);
    if (holds(task.sketch, placed, all[i])) option.score += asked_weight;
  }
  for (std::size_t i = 0; i < habits.size(); ++i) {
    if (holds(task.sketch, placed, all[task.asked.size() + i])) {
      option.score += habit_weight - habit_step * static_cast<double>(std::min<std::size_t>(i, 6));
      option.relations.push_back(habits[i]);
    } else if (i == 0) {
      option.leading = false;
    }
  }
  return option;
}

// All promising places for one way, the best first.
std::vector<Option> options_for(const Task& task, const std::vector<Relation>& way, double burden) {
  const auto habits = compatible_habits(task.asked, way);
  auto all = task.asked;
  all.insert(all.end(), habits.begin(), habits.end());
  auto poses = candidates(task.sketch, task.self, task.arrangement, all, task.company);
  if (!task.asked.empty()) {
    const auto more =
        candidates(task.sketch, task.self, task.arrangement, task.asked, task.company);
    poses.insert(poses.end(), more.begin(), more.end());
  }
  const auto resolved = resolve_all(task.sketch, task.self, all);
  std::vector<Option> options;
  double best = 0.0;
  for (const auto& pose : poses) {
    if (!task.sketch.allows(task.self, pose, task.bottom)) continue;
    options.push_back(judge(task, pose, habits, resolved));
    best = std::max(best, options.back().score);
  }
  // Comfort is dear to tell and never makes up for more than this.
  std::erase_if(options, [&](const Option& option) { return option.score < best - comfort_range; });
  for (auto& option : options) {
    const Placed placed{&task.self, option.pose, footprint_at(task.self, option.pose), task.bottom};
    option.score += comfort(task, placed, all, resolved) - burden_weight * burden;
  }
  std::stable_sort(options.begin(), options.end(),
                   [](const Option& a, const Option& b) { return a.score > b.score; });
  return options;
}

// The best option at a place of its own, passing over as many places as were refused; one from
// which everything can still be walked to if there is one among the better.
std::optional<Option> choose(const Task& task, const std::vector<Option>& options,
                             std::size_t refused) {
  std::vector<Vec2> passed;
  std::size_t walks = 0;
  const Option* first = nullptr;
  for (const auto& option : options) {
    const bool close = std::any_of(passed.begin(), passed.end(), [&](const Vec2& p) {
      return (p - option.pose.position).norm() < elsewhere;
    });
    if (close) continue;
    if (passed.size() < refused) {
      passed.push_back(option.pose.position);
      continue;
    }
    if (!first) first = &option;
    const bool matters = !task.self.traits.flat && task.self.mount == Mount::floor;
    if (!matters || all_reachable(task.sketch, task.self, option.pose, task.bottom)) return option;
    if (++walks == max_walks) break;
  }
  return first ? std::optional<Option>(*first) : std::nullopt;
}

std::optional<Option> best_place(const Task& task, std::size_t refused) {
  std::optional<Option> fallback;
  auto ways = task.arrangement.ways;
  if (task.needed)
    ways.insert(ways.end(), task.arrangement.otherwise.begin(), task.arrangement.otherwise.end());
  if (ways.empty()) ways.emplace_back();
  // After two refusals a way is given up, unless it is the last.
  const std::size_t start = std::min(refused / 2, ways.size() - 1);
  for (std::size_t w = start; w < ways.size(); ++w) {
    std::optional<Option> best;
    for (const auto& choice : resolve(task.sketch, task.self, ways[w])) {
      const auto options = options_for(task, choice.relations, choice.burden);
      auto option = choose(task, options, refused - 2 * start);
      if (option && (!best || option->score > best->score)) best = std::move(option);
    }
    if (best && best->leading) return best;
    if (best && task.needed && (!fallback || best->score > fallback->score))
      fallback = std::move(best);
  }
  return fallback;
}

void drop_wishes(std::vector<Relation>& relations, std::size_t asked, std::size_t refused) {
  const std::size_t keep =
      std::max<std::size_t>({asked, 1, relations.size() - std::min(relations.size(), refused)});
  if (relations.size() > keep) relations.resize(keep);
}

std::vector<Relation> known_only(const Sketch& sketch, const std::vector<Relation>& relations) {
  std::vector<Relation> known;
  for (const auto& relation : relations)
    if (relation.target.empty() || relation.target == "corner" ||
        !sketch.find(relation.target).empty())
      known.push_back(relation);
  return known;
}

// How many things of its kind the plan has for each table in the room.
int company(const PlaceRequest& request, const Sketch& sketch) {
  int seats = 0, tables = 0;
  for (const auto& item : request.plan.items)
    if (item.category == request.object.category) seats += item.quantity;
  for (const auto& one : sketch.standing())
    tables += one.object->mount == Mount::floor && one.object->size.z() > 0.6 &&
              sketch.categories().is_a(one.object->category, "table") && !one.object->traits.front;
  return (seats + std::max(1, tables) - 1) / std::max(1, tables);
}

std::string reason(const Option& option) {
  std::string text = to_text(option.relations);
  if (text.empty()) text = "where it is out of the way";
  return text + "; at " + format_number(option.pose.position.x(), 2) + ", " +
         format_number(option.pose.position.y(), 2);
}

}  // namespace

PlaceAdvice advise(const PlaceRequest& request, const KindTable& categories,
                   const Arrangements& arrangements) {
  const Sketch sketch(request.scene, categories, arrangements);
  const Object& self = request.object;
  const Arrangement& arrangement = arrangements.get(categories, self.category, self.mount);
  const PlanItem& item = request.plan.items.at(request.planned.item);
  const auto asked = known_only(sketch, item.relations);
  const std::size_t refused = request.refusals.size();
  if (self.mount == Mount::surface)
    return advise_on(sketch, self, arrangement, asked, item.on, refused);

  const Task task{sketch,
                  self,
                  arrangement,
                  asked,
                  item.location,
                  usual_bottom(self, categories.get(self.category), request.scene.room),
                  company(request, sketch),
                  item.asked || refused > 0};
  auto option = best_place(task, refused);
  if (!option && refused > 0) option = best_place(task, 0);
  if (!option) {
    // No place is free by this sketch; the solver, which knows the meshes, may find one.
    auto relations = asked;
    if (relations.empty() && self.mount != Mount::ceiling)
      relations.push_back({RelationKind::edge, ""});
    return {relations, item.location, std::nullopt, "no place is free in the sketch"};
  }
  drop_wishes(option->relations, asked.size(), refused);
  return {option->relations, option->pose.position, option->pose.yaw, reason(*option)};
}

}  // namespace roomgen::design
