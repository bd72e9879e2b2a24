#include "roomgen/lab/scores.h"

#include <algorithm>
#include <deque>
#include <set>

#include "evaluate/attributes.h"
#include "evaluate/identity.h"
#include "relation_score.h"
#include "room_physics.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

JudgedRequirement judge_count(const CountRequirement& requirement, std::size_t count) {
  JudgedRequirement verdict;
  verdict.text = requirement.text;
  verdict.satisfied = requirement.wanted.holds(static_cast<int>(count));
  verdict.reason = std::to_string(count) + " in the scene";
  if (!verdict.satisfied && static_cast<int>(count) < requirement.wanted.quantity)
    verdict.missing = requirement.category;
  return verdict;
}

// A thing counts that has all attributes of the requirement.
class AttributeCounter {
 public:
  AttributeCounter(const Scene& scene, const ModelTable& models) : scene_(scene), models_(models) {}

  JudgedRequirement judge(const AttributeRequirement& requirement, const std::vector<std::size_t>& things) {
    JudgedRequirement verdict;
    verdict.text = requirement.text;
    if (things.empty()) {
      verdict.reason = "no " + requirement.category;
      verdict.missing = requirement.category;
      return verdict;
    }
    int count = 0;
    std::set<std::string> faults;
    std::set<std::string> unjudged;
    for (const auto index : things) {
      bool all = true;
      for (const auto& attribute : requirement.attributes) {
        const auto found = judge_attribute(looks_of(index), attribute);
        if (found.held) continue;
        all = false;
        faults.insert(attribute + ": " + found.reason);
        if (!found.judged) unjudged.insert(attribute);
      }
      count += all;
    }
    verdict.satisfied = requirement.wanted.holds(count);
    verdict.reason = std::to_string(count) + " of " + std::to_string(things.size()) + " are so";
    if (!faults.empty()) verdict.reason += "; " + join({faults.begin(), faults.end()}, "; ");
    if (!verdict.satisfied) verdict.unjudged.assign(unjudged.begin(), unjudged.end());
    return verdict;
  }

 private:
  const KnownLooks& looks_of(std::size_t index) {
    const auto known = looks_.find(index);
    if (known != looks_.end()) return known->second;
    return looks_.emplace(index, known_looks(scene_.objects[index], models_)).first->second;
  }

  const Scene& scene_;
  const ModelTable& models_;
  std::map<std::size_t, KnownLooks> looks_;
};

template <typename Value>
void add_to(std::vector<Value>& all, const std::vector<Value>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// What is counted adds up; the free floor of a dwelling is the mean of its rooms'.
void add_room(const RoomScore& room, std::size_t rooms, RoomScore& score) {
  score.objects += room.objects;
  score.solids += room.solids;
  add_to(score.collisions, room.collisions);
  add_to(score.colliding, room.colliding);
  add_to(score.colliding_solids, room.colliding_solids);
  add_to(score.outside, room.outside);
  add_to(score.unsupported, room.unsupported);
  score.navigability += room.navigability / static_cast<double>(rooms);
  score.doors += room.doors;
  score.clear_doors += room.clear_doors;
  score.windows += room.windows;
  score.clear_windows += room.clear_windows;
  for (const auto& [opening, ids] : room.in_the_way)
    score.in_the_way[rooms > 1 ? room.id + ", " + opening : opening] = ids;
}

}  // namespace

RoomScore score_room(const Requirements& requirements, const Scene& scene,
                     const ModelTable& models) {
  RoomScore score;
  score.id = requirements.id;
  score.difficulty = requirements.difficulty;
  // In the order of the rooms, which for a single one is that of the file.
  Scene all = scene;
  all.objects.clear();
  std::vector<Thing> things;
  std::vector<const RoomSurfaces*> around;
  const auto parts = parts_of(scene);
  std::deque<RoomSurfaces> rooms;
  for (const auto& part : parts) {
    const RoomSurfaces& room = rooms.emplace_back(part.room);
    MeasuredRoom measured = measure_room(part, models, room);
    add_room(measured.score, parts.size(), score);
    add_to(all.objects, part.objects);
    add_to(things, measured.things);
    around.insert(around.end(), part.objects.size(), &room);
    if (!scene.rooms.empty()) score.rooms.push_back(std::move(measured.score));
  }

  const auto matched = identified_as(all.objects, requirements.categories());
  for (const auto& [category, indices] : matched)
    for (const auto index : indices) score.matched[category].push_back(all.objects[index].id);
  const MatchedThings context{things, around, matched};
  for (const auto& count : requirements.counts)
    score.counts.push_back(judge_count(count, matched.at(count.category).size()));
  AttributeCounter attributes(all, models);
  for (const auto& attribute : requirements.attributes)
    score.attributes.push_back(attributes.judge(attribute, matched.at(attribute.category)));
  for (const auto& relation : requirements.object_relations)
    score.object_relations.push_back(judge_relation(relation, context));
  for (const auto& relation : requirements.room_relations)
    score.room_relations.push_back(judge_relation(relation, context));
  return score;
}

}  // namespace roomgen::lab
