#include "roomgen/evaluate/score.h"

#include <algorithm>
#include <set>

#include "relation_score.h"
#include "roomgen/base/text.h"
#include "roomgen/evaluate/attributes.h"
#include "roomgen/evaluate/kind_names.h"
#include "roomgen/evaluate/navigability.h"
#include "roomgen/evaluate/opening_clearance.h"
#include "roomgen/evaluate/physics.h"
#include "roomgen/evaluate/support.h"

namespace roomgen {

namespace {

Verdict judge_count(const CountRequirement& requirement, std::size_t count) {
  Verdict verdict;
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

  Verdict judge(const AttributeRequirement& requirement, const std::vector<std::size_t>& things) {
    Verdict verdict;
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

void find_physics(const Scene& scene, const std::vector<Thing>& things, const RoomThings& parts,
                  RoomScore& score) {
  std::vector<Mount> mounts;
  std::vector<OrientedBox> boxes;
  for (const auto& object : scene.objects) {
    mounts.push_back(object.mount);
    boxes.push_back(box_of(object));
  }
  const auto held = sceneeval::supported(things, mounts, scene.room, parts);
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (!held[i]) score.unsupported.push_back(scene.objects[i].id);
    if (sceneeval::share_in_bounds(things[i], scene.room) < sceneeval::least_share_in_bounds)
      score.outside.push_back(scene.objects[i].id);
  }
  score.navigability = sceneeval::navigability(boxes, scene.room);
  const auto before = sceneeval::in_the_way(boxes, scene.room);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Opening& opening = scene.room.openings[k];
    ++(opening.is_entrance() ? score.doors : score.windows);
    if (before[k].empty()) ++(opening.is_entrance() ? score.clear_doors : score.clear_windows);
    for (const auto i : before[k]) score.in_the_way[opening.id].push_back(scene.objects[i].id);
  }
}

void find_collisions(const Scene& scene, const std::vector<Thing>& things, RoomScore& score) {
  std::set<std::size_t> all, solids;
  for (const auto& [i, j] : sceneeval::collisions(things)) {
    score.collisions.emplace_back(scene.objects[i].id, scene.objects[j].id);
    all.insert({i, j});
    if (!scene.objects[i].traits.flat && !scene.objects[j].traits.flat) solids.insert({i, j});
  }
  for (const auto i : all) score.colliding.push_back(scene.objects[i].id);
  for (const auto i : solids) score.colliding_solids.push_back(scene.objects[i].id);
}

}  // namespace

RoomScore score_room(const Requirements& requirements, const Scene& scene,
                     const ModelTable& models) {
  RoomScore score;
  score.id = requirements.id;
  score.difficulty = requirements.difficulty;
  score.objects = scene.objects.size();
  score.solids = static_cast<std::size_t>(
      std::count_if(scene.objects.begin(), scene.objects.end(),
                    [](const Object& object) { return !object.traits.flat; }));
  const auto matched = KindNames::built_in().match(scene.objects, requirements.categories());
  for (const auto& [category, indices] : matched)
    for (const auto index : indices) score.matched[category].push_back(scene.objects[index].id);

  std::vector<Thing> things;
  for (const auto& object : scene.objects) things.push_back(thing_of(object, models));
  const RoomThings parts = room_things(scene.room);
  const MatchedThings context{scene.room, parts, things, matched};
  for (const auto& count : requirements.counts)
    score.counts.push_back(judge_count(count, matched.at(count.category).size()));
  AttributeCounter attributes(scene, models);
  for (const auto& attribute : requirements.attributes)
    score.attributes.push_back(attributes.judge(attribute, matched.at(attribute.category)));
  for (const auto& relation : requirements.object_relations)
    score.object_relations.push_back(judge_relation(relation, context));
  for (const auto& relation : requirements.room_relations)
    score.room_relations.push_back(judge_relation(relation, context));

  find_collisions(scene, things, score);
  find_physics(scene, things, parts, score);
  return score;
}

}  // namespace roomgen
