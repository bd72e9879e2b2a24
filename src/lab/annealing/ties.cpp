#include <algorithm>

#include "evaluator.h"
#include "scene/judgement.h"

namespace roomgen::lab::annealing {

std::optional<Slot> Evaluator::slot_of(int kind_number) const {
  std::optional<Slot> found;
  world_.things().each([&](Slot slot) {
    if (world_.item(slot).kind_number == kind_number) found = slot;
  });
  return found;
}

Evaluator::Held Evaluator::judge_tie(const Tie& tie, Slot slot, const std::vector<Slot>& targets) const {
  const Item& item = world_.item(slot);
  Object object = item.object;
  object.relations = tie.relations;
  std::vector<Object> placed;
  for (const Slot target : targets) placed.push_back(world_.item(target).object);
  const auto resolved = resolve(object, world_.room(), placed, world_.kinds());
  const Subject subject{item.body.footprint, item.body.bottom, item.body.top};
  Held held;
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    const Judgement judgement = judge(resolved[i], subject, world_.room());
    held.degree += judgement.degree / static_cast<double>(resolved.size());
    if (!judgement.held) held.lost += tie.lost[i];
  }
  return held;
}

std::optional<Evaluator::Held> Evaluator::held(const Tie& tie) {
  const auto slot = slot_of(tie.kind_number);
  if (!slot) return std::nullopt;
  if (tie.relations.empty()) return Held{};
  std::vector<Slot> targets;
  Version together = 1;  // of all targets at once
  for (const int number : tie.targets) {
    const auto target =
        number < 0 ? std::nullopt : slot_of(program_.ties[static_cast<std::size_t>(number)].kind_number);
    together = together * 0x01000193u + (target ? world_.version(*target) : 0u);
    if (target && std::ranges::find(targets, *target) == targets.end()) targets.push_back(*target);
  }
  return ties_.get(world_.version(*slot), together, [&] { return judge_tie(tie, *slot, targets); });
}

}  // namespace roomgen::lab::annealing
