#include "relation_score.h"

#include <algorithm>
#include <functional>

#include "named_rooms.h"
#include "object_relations.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t max_groups = 20000;

// The best alternative's worst function.
template <typename Evaluate>
double score_of(const RelationMeaning& meaning, Evaluate evaluate_one) {
  double best = 0.0;
  for (const auto& alternative : meaning) {
    double worst = 1.0;
    for (const auto& function : alternative) {
      worst = std::min(worst, evaluate_one(function));
      if (worst <= best) break;
    }
    best = std::max(best, worst);
    if (best > sceneeval::satisfied_above) break;
  }
  return best;
}

std::string names_of(const RelationMeaning& meaning) {
  std::vector<std::string> alternatives;
  for (const auto& alternative : meaning) {
    std::vector<std::string> names;
    for (const auto& function : alternative)
      names.push_back((function.reversed ? "reversed " : "") + function.name +
                      (function.parameter.empty() ? "" : " " + function.parameter));
    alternatives.push_back(join(names, " and "));
  }
  return join(alternatives, " or ");
}

// All ways to choose `count` of the candidates; `use` returns false to stop.
bool combinations(const std::vector<std::size_t>& candidates, std::size_t count, std::size_t first,
                  std::vector<std::size_t>& chosen, const std::function<bool()>& use) {
  if (count == 0) return use();
  for (std::size_t i = first; i + count <= candidates.size(); ++i) {
    chosen.push_back(candidates[i]);
    const bool go_on = combinations(candidates, count - 1, i + 1, chosen, use);
    chosen.pop_back();
    if (!go_on) return false;
  }
  return true;
}

struct Other {
  std::string category;
  std::size_t count = 0;
};

// The categories besides the anchor, in order, and how many of each.
std::vector<Other> others_of(const ObjectRelationRequirement& relation, std::size_t anchor) {
  std::vector<Other> others;
  for (std::size_t i = 0; i < relation.things.size(); ++i) {
    if (i == anchor) continue;
    const auto known = std::find_if(others.begin(), others.end(), [&](const Other& other) {
      return other.category == relation.things[i];
    });
    if (known == others.end()) others.push_back({relation.things[i], 1});
    else ++known->count;
  }
  return others;
}

struct Groups {
  int tried = 0;
  int held = 0;
  double best = 0.0;
};

// What is between two things is one, between whichever two it is.
bool counts_anchors(const RelationMeaning& meaning) {
  return std::any_of(meaning.begin(), meaning.end(),
                     [](const auto& alternative) { return alternative.front().name == "between"; });
}

// Every anchor with every combination of the others, as SceneEval does; a thing is not its own
// other.
class GroupSearch {
 public:
  GroupSearch(const MatchedThings& scene, const std::vector<Other>& others,
              const RelationMeaning& meaning)
      : scene_(scene), others_(others), meaning_(meaning), once_(counts_anchors(meaning)) {}

  Groups run(const std::string& anchor_category) {
    for (const auto anchor : scene_.of(anchor_category)) {
      anchor_ = anchor;
      choose(0);
    }
    return groups_;
  }

 private:
  bool choose(std::size_t index) {
    if (index == others_.size()) return judge();
    std::vector<std::size_t> candidates = scene_.of(others_[index].category);
    candidates.erase(std::remove(candidates.begin(), candidates.end(), anchor_), candidates.end());
    return combinations(candidates, others_[index].count, 0, chosen_,
                        [&] { return choose(index + 1); });
  }

  bool judge() {
    std::vector<Thing> targets;
    for (const auto index : chosen_) targets.push_back(scene_.things[index]);
    const double score = score_of(meaning_, [&](const RelationFunction& function) {
      return evaluate(function, targets, scene_.things[anchor_], *scene_.around[anchor_]);
    });
    const bool held = score > sceneeval::satisfied_above;
    ++groups_.tried;
    if (held) ++groups_.held;
    groups_.best = std::max(groups_.best, score);
    return static_cast<std::size_t>(groups_.tried) < max_groups && !(held && once_);
  }

  const MatchedThings& scene_;
  const std::vector<Other>& others_;
  const RelationMeaning& meaning_;
  const bool once_;  // an anchor holds with one group or with several
  std::size_t anchor_ = 0;
  std::vector<std::size_t> chosen_;
  Groups groups_;
};

std::string findings(const RelationMeaning& meaning, const Groups& groups) {
  return names_of(meaning) + ": held by " + std::to_string(groups.held) + " of " +
         std::to_string(groups.tried) + ", best " + format_number(groups.best, 2);
}

}  // namespace

JudgedRequirement judge_relation(const ObjectRelationRequirement& relation, const MatchedThings& scene) {
  JudgedRequirement verdict;
  verdict.text = relation.text;
  // An index that points nowhere stands for the first thing.
  const std::size_t anchor = relation.anchor >= 0 && relation.anchor <
                                                         static_cast<int>(relation.things.size())
                                 ? static_cast<std::size_t>(relation.anchor)
                                 : 0;
  const auto others = others_of(relation, anchor);
  std::map<std::string, std::size_t> needed;
  for (const auto& thing : relation.things) ++needed[thing];
  for (const auto& thing : relation.things)
    if (scene.of(thing).size() < needed[thing]) {
      verdict.missing = thing;
      verdict.reason = scene.of(thing).empty() ? "no " + thing
                                               : "only " + std::to_string(scene.of(thing).size()) +
                                                     " of " + std::to_string(needed[thing]) + " " + thing;
      return verdict;
    }
  const auto meaning =
      RelationWords::built_in().between_objects(relation.relation, relation.things[anchor]);
  if (meaning.empty()) {
    verdict.reason = "the word \"" + relation.relation + "\" means nothing here";
    return verdict;
  }
  const Groups groups = GroupSearch(scene, others, meaning).run(relation.things[anchor]);
  verdict.satisfied = relation.wanted.holds(groups.held);
  verdict.reason = findings(meaning, groups);
  return verdict;
}

JudgedRequirement judge_relation(const RoomRelationRequirement& relation, const MatchedThings& scene) {
  JudgedRequirement verdict;
  verdict.text = relation.text;
  if (scene.of(relation.thing).empty()) {
    verdict.missing = relation.thing;
    verdict.reason = "no " + relation.thing;
    return verdict;
  }
  const std::string part = lower(relation.parts.front());
  const auto meaning = RelationWords::built_in().to_room(relation.relation, part);
  if (meaning.empty()) {
    verdict.reason = "\"" + relation.relation + "\" of \"" + part + "\" means nothing here";
    return verdict;
  }
  const NamedRooms named(part, scene.around);
  Groups groups;
  for (const auto index : scene.of(relation.thing)) {
    const RoomSurfaces& around = *scene.around[index];
    const double score = score_of(meaning, [&](const RelationFunction& function) {
      return named.contain(around.room) ? evaluate(function, scene.things[index], part, around)
                                        : 0.0;
    });
    ++groups.tried;
    if (score > sceneeval::satisfied_above) ++groups.held;
    groups.best = std::max(groups.best, score);
  }
  verdict.satisfied = relation.wanted.holds(groups.held);
  verdict.reason = findings(meaning, groups);
  return verdict;
}

}  // namespace roomgen::lab
