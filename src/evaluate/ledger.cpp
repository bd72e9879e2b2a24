#include "ledger.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

class Checker {
 public:
  Checker(std::span<const Requirement> all, const Scene& scene, const KindTable& categories,
          const AttributeJudge& has_attribute)
      : all_(all), scene_(scene), categories_(categories), has_attribute_(has_attribute) {}

  // Why it is not met; empty if it is.
  std::string fault(const Requirement& requirement) const {
    switch (requirement.kind) {
      case Requirement::Kind::count:
        return count_fault(requirement);
      case Requirement::Kind::attribute:
        if (const std::string* material = material_of(requirement.category))
          return *material == requirement.attribute ? "" : "it is \"" + *material + "\"";
        return each(requirement, [&](const Object& object) {
          return has_attribute_(object, requirement.attribute);
        });
      case Requirement::Kind::relation:
        return each(requirement,
                    [&](const Object& object) { return relation_fault(requirement, object); });
      case Requirement::Kind::absence: {
        const int there = number_of(requirement.category);
        return there == 0 ? "" : "there are " + std::to_string(there);
      }
    }
    return "";
  }

 private:
  // What a part of the room is covered with; null for things.
  const std::string* material_of(std::string_view part) const {
    const RoomMaterials& materials = scene_.room.materials;
    if (part == "floor") return &materials.floor;
    if (part == "walls") return &materials.walls;
    if (part == "ceiling") return &materials.ceiling;
    return part == "accent wall" ? &materials.accent : nullptr;
  }

  // Without the things of which another count speaks: "four novels and two art books".
  int number_of(const std::string& category, const Requirement* asking = nullptr) const {
    return static_cast<int>(
        std::count_if(scene_.objects.begin(), scene_.objects.end(), [&](const Object& object) {
          return categories_.is_a(object.category, category) &&
                 !(asking && is_another_count(*asking, object.id));
        }));
  }

  bool is_another_count(const Requirement& asking, const std::string& id) const {
    const auto names = [&](const Requirement& one) {
      return std::find(one.subjects.begin(), one.subjects.end(), id) != one.subjects.end();
    };
    return !asking.subjects.empty() && !names(asking) &&
           std::any_of(all_.begin(), all_.end(), [&](const Requirement& other) {
             return other.kind == Requirement::Kind::count && names(other);
           });
  }

  std::string count_fault(const Requirement& requirement) const {
    for (const auto& id : requirement.subjects)
      if (!find_object(scene_, id)) return missing(id);
    const int there = number_of(requirement.category, &requirement);
    const bool enough = there >= requirement.count;
    if (enough && (requirement.at_least || there == requirement.count)) return "";
    return "there are " + std::to_string(there) + " instead of " + std::to_string(requirement.count);
  }

  std::string missing(const std::string& id) const {
    for (const auto& unplaced : scene_.unplaced)
      if (unplaced.id == id) return id + " was left out: " + unplaced.reason;
    return id + " is not there";
  }

  template <typename Fault>
  std::string each(const Requirement& requirement, const Fault& fault_of) const {
    if (requirement.subjects.empty()) return "there is no " + requirement.category;
    for (const auto& id : requirement.subjects) {
      const Object* object = find_object(scene_, id);
      if (!object) return missing(id);
      if (std::string fault = fault_of(*object); !fault.empty()) return id + ": " + fault;
    }
    return "";
  }

  std::string relation_fault(const Requirement& requirement, const Object& object) const {
    const auto holds = [&](const std::string& target) {
      if (requirement.relation == RelationKind::on && object.on == target) return true;
      Object asked = object;
      // Alignment depends on what else is asked of the same target.
      std::erase_if(asked.relations, [&](const Relation& other) { return other.target != target; });
      asked.relations.push_back({requirement.relation, target});
      const auto resolved = resolve(asked, scene_.room, scene_.objects, categories_);
      return judge(resolved.back(), {footprint(object), bottom(object), top(object)}, scene_.room).held;
    };
    const auto& targets = requirement.targets;
    if (targets.empty() ? holds("") : std::any_of(targets.begin(), targets.end(), holds)) return "";
    return "is not " + std::string(name(requirement.relation)) +
           (targets.empty() ? "" : " " + join(targets, " or "));
  }

  std::span<const Requirement> all_;
  const Scene& scene_;
  const KindTable& categories_;
  const AttributeJudge& has_attribute_;
};

}  // namespace

std::vector<RequirementVerdict> check_requirements(std::span<const Requirement> requirements,
                                                   const Scene& scene,
                                                   const KindTable& categories,
                                                   const AttributeJudge& has_attribute) {
  const Checker checker(requirements, scene, categories, has_attribute);
  std::vector<RequirementVerdict> verdicts;
  for (const auto& requirement : requirements) {
    std::string fault = checker.fault(requirement);
    verdicts.push_back({requirement, fault.empty(), std::move(fault)});
  }
  return verdicts;
}

}  // namespace roomgen
