#include "to_scene.h"

#include <algorithm>
#include <vector>

#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen::lab::annealing {

namespace {

// Slots in an order in which carriers come first.
std::vector<Slot> in_order(const World& world) {
  std::vector<Slot> order;
  SlotSet waiting = world.things();
  while (!waiting.empty()) {
    const std::size_t before = order.size();
    const SlotSet round = waiting;
    round.each([&](Slot slot) {
      for (const auto& attachment : world.item(slot).stance.held())
        if (attachment.target < most_things && waiting.has(attachment.target)) return;
      order.push_back(slot);
      waiting.erase(slot);
    });
    if (order.size() == before) waiting.each([&](Slot slot) { order.push_back(slot), waiting.erase(slot); });
  }
  return order;
}

// As plans name their objects (roomgen/scene/plan.h), so that what a plan asks for is found.
std::string id_of(const std::string& category, int number) { return lower(category) + "-" + std::to_string(number); }

// What a way of being put up amounts to in the grammar of relations.
std::vector<Relation> relations_of(const Attachment& attachment, const std::map<Slot, std::string>& ids) {
  using enum RelationKind;
  if (attachment.parent == Face::wall) return {{edge, ""}};
  if (attachment.target >= most_things) return {};
  const std::string& target = ids.at(attachment.target);
  if (attachment.parent == Face::top || attachment.parent == Face::support) return {{on, target}, {inside, target}};
  if (attachment.child == Face::front) return {{face_to, target}, {near, target}};
  return {{side_of, target}, {near, target}};
}

void keep_what_holds(Scene& scene, const KindTable& kinds) {
  const auto verdicts = judge_scene(scene, kinds);
  for (auto& object : scene.objects)
    std::erase_if(object.relations, [&](const Relation& relation) {
      return std::ranges::none_of(verdicts, [&](const RelationVerdict& verdict) {
        return verdict.object == object.id && verdict.relation == relation && verdict.judgement.held;
      });
    });
}

}  // namespace

Exported to_scene(const World& world, const KindTable& kinds) {
  Exported result;
  result.scene.room = world.room();
  std::map<std::string, int> numbers;
  for (const Slot slot : in_order(world)) {
    Object object = world.item(slot).object;
    object.id = result.ids[slot] = id_of(object.category, numbers[object.category]++);
    object.on.clear();
    if (const auto carrier = world.carrier(slot)) object.on = result.ids.at(*carrier);
    result.scene.objects.push_back(std::move(object));
  }
  for (const auto& [slot, id] : result.ids)
    for (const auto& attachment : world.item(slot).stance.held())
      for (const auto& relation : relations_of(attachment, result.ids))
        find_object(result.scene, id)->relations.push_back(relation);
  keep_what_holds(result.scene, kinds);
  return result;
}

}  // namespace roomgen::lab::annealing
