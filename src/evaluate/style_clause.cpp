#include <algorithm>
#include <string>
#include <vector>

#include "evaluate/clauses.h"
#include "library/style_words.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// Does a part of the room show it: "navy walls"?
bool is_of_room(const std::string& word, const Room& room) {
  const RoomMaterials& materials = room.materials;
  std::vector<std::string> walls = {materials.walls};
  for (const auto& cover : materials.covers) {
    walls.push_back(cover.finish);
    if (cover.lower) walls.push_back(cover.lower->finish);
  }
  const auto shows = [&](const std::string& worn, RoomPart part) {
    return !worn.empty() && finish_fault(word, worn, part, room.type).empty();
  };
  return shows(materials.floor, RoomPart::floor) || shows(materials.ceiling, RoomPart::ceiling) ||
         std::any_of(walls.begin(), walls.end(),
                     [&](const std::string& worn) { return shows(worn, RoomPart::walls); });
}

}  // namespace

Finding judge_style(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute) {
  if (!StyleWords::built_in().find(requirement.category) || !has_attribute) return {Compliance::not_judged, "nothing measures it"};
  int judged = 0, held = 0;
  for (const auto& object : scene.objects) {
    if (object.mount == Mount::surface) continue;
    const auto verdict = has_attribute(object, requirement.category);
    judged += verdict.judged ? 1 : 0;
    held += verdict.judged && verdict.held ? 1 : 0;
  }
  if (judged == 0) return {Compliance::not_judged, "nothing shows of what style its things are"};
  return by_fault(2 * held >= judged ? "" : std::to_string(held) + " of " + std::to_string(judged) + " pieces of furniture are so");
}

Finding judge_palette(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute) {
  if (!has_attribute) return {Compliance::not_judged, "nothing measures it"};
  for (const auto& word : words(requirement.category)) {
    const bool is_there = is_of_room(word, scene.room) || std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
      const auto verdict = has_attribute(object, word);
      return verdict.judged && verdict.held;
    });
    if (!is_there) return by_fault("nothing is known to be " + word);
  }
  return {};
}

}  // namespace roomgen
