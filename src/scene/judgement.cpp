#include "judgement.h"

#include "relation_table.h"

namespace roomgen {

Judgement judge(const ResolvedRelation& relation, const Subject& subject, const Room& room) {
  const auto judge_one = definition(relation.kind).judge;
  Judgement best;
  for (const auto& target : relation.targets) {
    const Judgement judgement = judge_one({relation, subject, target, room});
    if (judgement.held > best.held ||
        (judgement.held == best.held && judgement.degree > best.degree))
      best = judgement;
  }
  return best;
}

std::vector<RelationVerdict> judge_scene(const Scene& scene, const KindTable& categories) {
  std::vector<RelationVerdict> verdicts;
  if (!scene.rooms.empty()) {
    for (const auto& part : parts_of(scene))
      for (auto& verdict : judge_scene(part, categories)) verdicts.push_back(std::move(verdict));
    return verdicts;
  }
  for (const auto& object : scene.objects) {
    const Subject subject{footprint(object), bottom(object), top(object)};
    const auto resolved = resolve(object, scene.room, scene.objects, categories);
    for (std::size_t i = 0; i < resolved.size(); ++i)
      verdicts.push_back({object.id, object.relations[i], judge(resolved[i], subject, scene.room)});
  }
  return verdicts;
}

}  // namespace roomgen
