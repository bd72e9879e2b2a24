#include "roomgen/evaluate/score.h"

#include <algorithm>
#include <set>

#include "relation_score.h"
#include "roomgen/evaluate/kind_names.h"
#include "roomgen/evaluate/physics.h"

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
  for (const auto& relation : requirements.object_relations)
    score.object_relations.push_back(judge_relation(relation, context));
  for (const auto& relation : requirements.room_relations)
    score.room_relations.push_back(judge_relation(relation, context));

  find_collisions(scene, things, score);
  for (std::size_t i = 0; i < things.size(); ++i)
    if (sceneeval::share_in_bounds(things[i], scene.room) < sceneeval::least_share_in_bounds)
      score.outside.push_back(scene.objects[i].id);
  return score;
}

}  // namespace roomgen
