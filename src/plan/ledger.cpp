#include "ledger.h"

#include <algorithm>
#include <map>

#include "floor_plan.h"

namespace roomgen::design {

namespace {

class Ledger {
 public:
  Ledger(const Brief& brief, const std::vector<Draft>& drafts, const Plan& plan)
      : brief_(brief), room_(plan.room) {
    for (const auto& planned : planned_objects(plan)) {
      const std::size_t mention = drafts[planned.item].mention;
      if (mention != Demand::none) ids_[mention].push_back(planned.id);
    }
  }

  std::vector<Requirement> run() {
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i) {
      const Mention& mention = brief_.mentions[i];
      count(i, mention);
      for (const auto& look : mention.looks) attribute(i, mention, look);
      for (const auto& demand : mention.demands) relation(i, mention, demand);
    }
    for (const auto& category : brief_.excluded) absence(category);
    material("floor", brief_.materials.floor);
    material("walls", brief_.materials.walls);
    material("ceiling", brief_.materials.ceiling);
    material("accent wall", brief_.materials.accent);
    return std::move(requirements_);
  }

 private:
  Requirement about(std::size_t index, const Mention& mention, Requirement::Kind kind) {
    Requirement requirement;
    requirement.kind = kind;
    requirement.category = mention.category;
    if (const auto found = ids_.find(index); found != ids_.end()) requirement.subjects = found->second;
    return requirement;
  }

  void count(std::size_t index, const Mention& mention) {
    Requirement requirement = about(index, mention, Requirement::Kind::count);
    requirement.count = mention.quantity;
    requirement.at_least = !mention.counted;
    requirement.clause = (mention.quantity == 1 ? "a" : std::to_string(mention.quantity)) + " " +
                         mention.description;
    requirements_.push_back(std::move(requirement));
  }

  void attribute(std::size_t index, const Mention& mention, const std::string& look) {
    Requirement requirement = about(index, mention, Requirement::Kind::attribute);
    requirement.attribute = look;
    requirement.clause = look + " " + mention.category;
    requirements_.push_back(std::move(requirement));
  }

  void relation(std::size_t index, const Mention& mention, const Demand& demand) {
    // Of those that share the long sides half are behind the target.
    if (demand.flank && demand.kind == RelationKind::in_front_of) return;
    Requirement requirement = about(index, mention, Requirement::Kind::relation);
    requirement.relation = demand.kind;
    requirement.clause = mention.category + " " + std::string(name(demand.kind));
    if (demand.mention != Demand::none) {
      requirement.targets = ids_[demand.mention];
      requirement.clause += " " + brief_.mentions[demand.mention].category;
    } else if (!demand.part.empty()) {
      requirement.targets = {part_of(room_, demand.part)};
      requirement.clause += " " + demand.part;
    }
    if (std::find(requirements_.begin(), requirements_.end(), requirement) == requirements_.end())
      requirements_.push_back(std::move(requirement));
  }

  void material(const std::string& part, const std::string& said) {
    if (said.empty()) return;
    Requirement requirement;
    requirement.kind = Requirement::Kind::attribute;
    requirement.clause = said;
    requirement.category = part;
    requirement.attribute = said;
    requirements_.push_back(std::move(requirement));
  }

  void absence(const std::string& category) {
    Requirement requirement;
    requirement.kind = Requirement::Kind::absence;
    requirement.category = category;
    requirement.clause = "no " + category;
    requirements_.push_back(std::move(requirement));
  }

  const Brief& brief_;
  const Room& room_;
  std::map<std::size_t, std::vector<std::string>> ids_;  ///< by mention
  std::vector<Requirement> requirements_;
};

}  // namespace

std::vector<Requirement> requirements_of(const Brief& brief, const std::vector<Draft>& drafts,
                                         const Plan& plan) {
  return Ledger(brief, drafts, plan).run();
}

}  // namespace roomgen::design
