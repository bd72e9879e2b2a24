#include "ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "clauses.h"
#include "finding.h"
#include "identity.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "scene/attribute_names.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

constexpr int least_kind_rank = 3;   // of identity_rank(): it or a kind of it
constexpr double as_good = 0.75;     // of Vocabulary::fit(): a thing that serves who asks for it
constexpr double length_tolerance = 0.05, least_tolerance = 0.02;  // share, metres

// Put together from words that nobody knows (create.h): it may be anything.
bool is_approximate(const AssetRef& asset) {
  if (!asset.procedural) return false;
  const auto params = parse_json(asset.procedural->params, "params");
  return params && params->is_object() && params->value("approximate", false);
}

class Checker {
 public:
  Checker(std::span<const Requirement> all, const Scene& scene, const KindTable& categories,
          const AttributeJudge& has_attribute, const SizeShare& size_share)
      : all_(all), scene_(scene), categories_(categories), has_attribute_(has_attribute), size_share_(size_share) {}

  // What is said of a thing is not met by another one that stands there in its place.
  Finding check(const Requirement& requirement) const {
    Finding finding = check_clause(requirement);
    const bool is_of_things =
        requirement.kind == Requirement::Kind::attribute || requirement.kind == Requirement::Kind::relation ||
        requirement.kind == Requirement::Kind::each;
    if (!is_of_things || finding.compliance != Compliance::met) return finding;
    const auto doubtful = [&](const std::string& id) { return is_doubtful(id); };
    const auto subject = std::find_if(requirement.subjects.begin(), requirement.subjects.end(), doubtful);
    if (subject != requirement.subjects.end()) return not_shown(*subject);
    const auto& targets = requirement.targets;
    if (!targets.empty() && std::all_of(targets.begin(), targets.end(), doubtful)) return not_shown(targets.front());
    return finding;
  }

 private:
  static Finding not_shown(const std::string& id) {
    return {Compliance::not_judged, "nothing shows that " + id + " is what was asked for"};
  }
  // Is it counted as something that nothing shows it to be?
  bool is_doubtful(const std::string& id) const {
    const Object* object = find_object(scene_, id);
    return object && std::any_of(all_.begin(), all_.end(), [&](const Requirement& count) {
      return count.kind == Requirement::Kind::count &&
             std::find(count.subjects.begin(), count.subjects.end(), id) != count.subjects.end() &&
             (judge_identity(*object, count.category).compliance != Compliance::met ||
              !(is_of_sort(*object, count.attribute) || is_said_apart(count)));
    });
  }
  // Of a "prop chest" a clause of its own says that nothing shows it to be a prop: a chest it is.
  bool is_said_apart(const Requirement& count) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Requirement& look) {
      return look.kind == Requirement::Kind::attribute && look.attribute == count.attribute && look.subjects == count.subjects;
    });
  }

  Finding check_clause(const Requirement& requirement) const {
    switch (requirement.kind) {
      case Requirement::Kind::count:
        return judge_count(requirement);
      case Requirement::Kind::attribute:
        if (is_of_shell(requirement)) return by_fault(shell_fault(requirement));
        if (is_formation(requirement)) return judge_formation(requirement);
        return each(requirement,
                    [&](const Object& object) { return judge_attribute(requirement, object); });
      case Requirement::Kind::relation:
        return each(requirement, [&](const Object& object) {
          return by_fault(requirement.denied ? denial_fault(requirement, object) : relation_fault(requirement, object));
        });
      case Requirement::Kind::each:
        return judge_each(requirement);
      case Requirement::Kind::only:
        return by_fault(other_fault(requirement, scene_, [&](const Object& object) {
          return categories_.is_a(object.category, requirement.category) || is_shown_to_be(object, requirement.category);
        }));
      case Requirement::Kind::absence:
        return judge_absence(requirement);
      case Requirement::Kind::room:
        return judge_whole_room(requirement);
    }
    return {};
  }

  Finding judge_whole_room(const Requirement& requirement) const {
    if (requirement.attribute == "rooms") return count_rooms(requirement);
    if (requirement.attribute == style_of_room) return judge_style(requirement, scene_, has_attribute_);
    if (requirement.attribute == palette_of_room) return judge_palette(requirement, scene_, has_attribute_);
    if (requirement.attribute == seats_for_people) return judge_seats(requirement, scene_, categories_);
    return judge_room(requirement, scene_.room);
  }

  Finding count_rooms(const Requirement& requirement) const {
    const auto rooms = rooms_of(scene_);
    const auto there =
        std::count_if(rooms.begin(), rooms.end(),
                      [&](const Room& room) { return room.type == requirement.category; });
    const bool met = there == static_cast<std::ptrdiff_t>(requirement.amount);
    return by_fault(met ? "" : "there are " + std::to_string(there));
  }

  // "no television", "no glass tables", "no pink"
  Finding judge_absence(const Requirement& requirement) const {
    Finding finding;
    for (const auto& object : scene_.objects) {
      const bool is_meant = requirement.category.empty() || categories_.is_a(object.category, requirement.category) ||
                            is_shown_to_be(object, requirement.category);
      if (!is_meant) continue;
      if (requirement.attribute.empty()) return by_fault("there is " + object.id);
      const auto verdict = has_attribute_(object, requirement.attribute);
      if (verdict.held) return by_fault(object.id + " is " + requirement.attribute);
      if (!verdict.judged) finding = {Compliance::not_judged, object.id + ": " + verdict.reason};
    }
    return finding;
  }

  Finding judge_attribute(const Requirement& requirement, const Object& object) const {
    const std::string& asked = requirement.attribute;
    if (requirement.amount > 0.0) return by_fault(length_fault(requirement, object));
    if (asked.starts_with(mount_attribute))
      return by_fault(asked.substr(mount_attribute.size()) == name(object.mount)
                          ? ""
                          : "its mount is " + std::string(name(object.mount)));
    const auto verdict = has_attribute_(object, asked);
    if (!verdict.judged) return {Compliance::not_judged, verdict.reason};
    return by_fault(verdict.held ? "" : "is not known to be " + asked + ": " + verdict.reason);
  }

  static bool is_formation(const Requirement& requirement) {
    const auto& asked = requirement.attribute;
    return asked == in_rows || asked == in_circle || asked == in_arc || asked == in_islands;
  }
  // Of all its things together.
  Finding judge_formation(const Requirement& requirement) const {
    std::vector<const Object*> things;
    for (const auto& id : requirement.subjects) {
      things.push_back(find_object(scene_, id));
      if (!things.back()) return by_fault(missing(id));
    }
    if (requirement.attribute == in_circle) return by_fault(circle_fault(things));
    if (requirement.attribute == in_arc) return by_fault(arc_fault(things));
    if (requirement.attribute == in_islands) return by_fault(islands_fault(things, requirement.count));
    return by_fault(rows_fault(things, requirement.count));
  }

  // Hung at a height is what has it between its bottom and its top, to a few centimetres.
  static std::string height_fault(const Requirement& requirement, const Object& object) {
    constexpr double tolerance = 0.05;
    const double low = bottom(object), high = top(object), asked = requirement.amount;
    const bool is_low = high + tolerance < asked, is_high = low - tolerance > asked;
    if ((!is_low || requirement.at_most) && (!is_high || requirement.at_least)) return "";
    return "it hangs from " + format_number(low, 2) + " to " + format_number(high, 2) + " m above the floor";
  }

  static std::string length_fault(const Requirement& requirement, const Object& object) {
    if (requirement.attribute == height_above_floor) return height_fault(requirement, object);
    const Vec3& size = object.size;
    const std::string& side = requirement.attribute;
    const double there = side == "height"  ? size.z()
                         : side == "depth" ? size.y()
                         : side == "width" ? size.x()
                                           : std::max(size.x(), size.y());
    const double tolerance = std::max(least_tolerance, length_tolerance * requirement.amount);
    const double over = there - requirement.amount;
    if (std::abs(over) <= tolerance || (requirement.at_least && over > 0.0) ||
        (requirement.at_most && over < 0.0))
      return "";
    return "its " + side + " is " + format_number(there, 2) + " m";
  }

  static bool is_of_shell(const Requirement& said) {
    static const std::set<std::string_view> parts = {"floor", "walls", "ceiling", "accent wall"};
    return parts.count(said.category) > 0;
  }
  // What viewers see of a part of the room instead of what was asked; of walls on none of those
  // that may be meant.
  std::string shell_fault(const Requirement& said) const {
    const Room& room = scene_.room;
    const RoomMaterials& materials = room.materials;
    const auto fault = [&](const std::string& worn, RoomPart part) {
      return finish_fault(said.attribute, worn, part, room.type);
    };
    if (said.category == "floor") return fault(materials.floor, RoomPart::floor);
    if (said.category == "ceiling") return fault(materials.ceiling, RoomPart::ceiling);
    const bool is_accent = said.category == "accent wall";
    const std::string first =
        fault(is_accent ? finish_named(materials, accent_name) : materials.walls, RoomPart::walls);
    const bool is_shown =
        std::any_of(materials.covers.begin(), materials.covers.end(), [&](const WallCover& cover) {
          const bool is_lower = cover.lower && !cover.lower->finish.empty() &&
                                fault(cover.lower->finish, RoomPart::walls).empty();
          const bool is_meant = is_accent ? !cover.wall.empty() : cover.wall.empty();
          return is_meant && (is_lower || (!cover.finish.empty() &&
                                           fault(cover.finish, RoomPart::walls).empty()));
        });
    return is_shown ? "" : first;
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
    const bool may_be_fewer = requirement.at_most || requirement.most > requirement.count;
    for (const auto& id : requirement.subjects) {
      const Object* object = find_object(scene_, id);
      if (!object && may_be_fewer) continue;
      if (!object) return missing(id);
      if (const double share = size_share_ ? size_share_(*object) : 1.0; share < least_size_share)
        return id + " was made at " + format_number(100.0 * share, 0) + " % of its size";
    }
    const int there = number_of(requirement.category, &requirement);
    const bool enough = there >= requirement.count;
    if (requirement.at_most && there <= requirement.count) return "";
    if (enough && (requirement.at_least || there <= std::max(requirement.count, requirement.most))) return "";
    return "there are " + std::to_string(there) + " instead of " + std::to_string(requirement.count);
  }

  // By what made it, whatever it was placed as.
  bool is_shown_to_be(const Object& object, const std::string& category) const {
    return identity_rank(identify(object), category) >= least_kind_rank;
  }

  // Is its mesh of another kind, and of none that would do? What nobody knows is no other kind.
  std::string other_kind(const Object& object, const std::string& category) const {
    const Identity identity = identify(object);
    const Vocabulary& vocabulary = Vocabulary::built_in();
    const bool known = vocabulary.kinds().named(identity.kind) && vocabulary.kinds().named(category);
    const bool serves = identity_rank(identity, category) > 0 || vocabulary.fit(identity.kind, category) >= as_good;
    return known && !serves ? identity.kind : "";
  }

  // Nothing shows that what stands in for a thing is one, and a mesh of another kind is none.
  Finding judge_count(const Requirement& requirement) const {
    Finding finding = by_fault(count_fault(requirement));
    if (finding.compliance != Compliance::met) return finding;
    for (const auto& object : scene_.objects) {
      if (!categories_.is_a(object.category, requirement.category)) continue;
      if (Finding identity = judge_identity(object, requirement.category); identity.compliance != Compliance::met)
        return identity;
    }
    return judge_sort(requirement);
  }

  Finding judge_identity(const Object& object, const std::string& category) const {
    if (object.stand_in || is_approximate(object.asset))
      return {Compliance::not_judged, "nothing shows that " + object.id + " is one"};
    const std::string other = other_kind(object, category);
    return by_fault(other.empty() ? "" : object.id + " is a " + other);
  }

  // A coffee grinder is no grinder of another sort: what nothing shows to be one, may be none.
  Finding judge_sort(const Requirement& requirement) const {
    for (const auto& id : requirement.subjects)
      if (const Object* object = find_object(scene_, id); object && !is_of_sort(*object, requirement.attribute))
        return {Compliance::not_judged, id + ": nothing shows that it is of the sort \"" + requirement.attribute + "\""};
    return {};
  }
  bool is_of_sort(const Object& object, const std::string& sort) const {
    if (sort.empty()) return true;
    const auto verdict = has_attribute_(object, sort);
    return verdict.judged && verdict.held;
  }

  std::string missing(const std::string& id) const {
    for (const auto& unplaced : scene_.unplaced)
      if (unplaced.id == id) return id + " was left out: " + unplaced.reason;
    return id + " is not there";
  }

  // The worst that is found of any of its things: one that is not so weighs more than one of which
  // nothing shows it.
  template <typename Judge>
  Finding each(const Requirement& requirement, const Judge& judge_one) const {
    if (requirement.subjects.empty()) return by_fault("there is no " + requirement.category);
    Finding worst{Compliance::met, ""};
    for (const auto& id : requirement.subjects) {
      const Object* object = find_object(scene_, id);
      if (!object) return by_fault(missing(id));
      Finding finding = judge_one(*object);
      if (finding.compliance == Compliance::met) continue;
      finding.reason = id + ": " + finding.reason;
      if (finding.compliance == Compliance::not_met) return finding;
      worst = std::move(finding);
    }
    return worst;
  }

  // Between any two of the targets.
  bool is_between(const std::vector<std::string>& targets, const Object& object) const {
    Object asked = object;
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (std::size_t j = i + 1; j < targets.size(); ++j) {
        asked.relations = {{RelationKind::between, targets[i]}, {RelationKind::between, targets[j]}};
        const auto resolved = resolve(asked, scene_.room, scene_.objects, categories_);
        if (judge(resolved.front(), {footprint(object), bottom(object), top(object)}, scene_.room)
                .held)
          return true;
      }
    return false;
  }

  bool holds(RelationKind relation, const Object& object, const std::string& target) const {
    return holds(Relation{relation, target}, object);
  }
  bool holds(const Relation& relation, const Object& object) const {
    const std::string& target = relation.target;
    if (relation.kind == RelationKind::on && object.on == target) return true;
    Object asked = object;
    // Alignment depends on what else is asked of the same target.
    std::erase_if(asked.relations, [&](const Relation& other) { return other.target != target; });
    asked.relations.push_back(relation);
    const auto is_so = [&] {
      const auto resolved = resolve(asked, scene_.room, scene_.objects, categories_);
      return judge(resolved.back(), {footprint(object), bottom(object), top(object)}, scene_.room).held;
    };
    if (is_so()) return true;
    // Before and behind a desk is as its user sits, or as one who comes to it stands.
    const Object* other = find_object(scene_, target);
    RelationKind& kind = asked.relations.back().kind;
    if (!other || categories_.get(other->category).faces != Side::back) return false;
    if (kind != RelationKind::behind && kind != RelationKind::in_front_of) return false;
    kind = kind == RelationKind::behind ? RelationKind::in_front_of : RelationKind::behind;
    return is_so();
  }

  std::string denial_fault(const Requirement& requirement, const Object& object) const {
    for (const auto& target : requirement.targets)
      if (holds(requirement.relation, object, target))
        return "is " + std::string(name(requirement.relation)) + " " + target;
    return "";
  }

  // "a lamp on each desk", "a plant in each corner"
  Finding judge_each(const Requirement& requirement) const {
    std::vector<const Object*> things;
    for (const auto& id : requirement.subjects)
      if (const Object* object = find_object(scene_, id)) things.push_back(object);
    if (requirement.relation == RelationKind::corner)
      return by_fault(corners_fault(things, scene_.room, requirement.count, [&](const Object& object) {
        return holds(RelationKind::corner, object, "");
      }));
    std::vector<std::string> owners;
    for (const auto& id : requirement.targets)
      if (find_object(scene_, id) || find_opening(scene_.room, id)) owners.push_back(id);
    return by_fault(each_fault(things, owners, requirement.count, [&](const Object& object, const std::string& owner) {
      return holds(requirement.relation, object, owner);
    }));
  }

  // "at least 1.5 m from every wall" is so of all targets, "2 m from the window" of one.
  std::string gap_fault(const Requirement& requirement, const Object& object) const {
    const Gap gap{requirement.at_most ? 0.0 : requirement.amount,
                  requirement.at_least ? std::numeric_limits<double>::infinity() : requirement.amount};
    std::vector<std::string> targets = requirement.targets;
    std::erase(targets, object.id);  // "two beds 60 cm apart"
    const auto is_so = [&](const std::string& target) { return holds(Relation{RelationKind::gap, target, gap}, object); };
    const bool are_met = requirement.at_least ? std::all_of(targets.begin(), targets.end(), is_so)
                                              : std::any_of(targets.begin(), targets.end(), is_so);
    return are_met ? "" : "is not " + to_text(gap) + " from " + join(targets, requirement.at_least ? " and " : " or ");
  }

  std::string relation_fault(const Requirement& requirement, const Object& object) const {
    if (requirement.relation == RelationKind::between)
      return is_between(requirement.targets, object)
                 ? ""
                 : "is not between " + join(requirement.targets, " and ");
    if (requirement.relation == RelationKind::gap) return gap_fault(requirement, object);
    const auto is_so = [&](const std::string& target) { return holds(requirement.relation, object, target); };
    const auto& targets = requirement.targets;
    if (targets.empty() ? is_so("") : std::any_of(targets.begin(), targets.end(), is_so)) return "";
    return "is not " + std::string(name(requirement.relation)) +
           (targets.empty() ? "" : " " + join(targets, " or "));
  }

  std::span<const Requirement> all_;
  const Scene& scene_;
  const KindTable& categories_;
  const AttributeJudge& has_attribute_;
  const SizeShare& size_share_;
};

}  // namespace

std::vector<RequirementVerdict> check_requirements(std::span<const Requirement> requirements,
                                                   const Scene& scene,
                                                   const KindTable& categories,
                                                   const AttributeJudge& has_attribute,
                                                   const SizeShare& size_share) {
  const Checker checker(requirements, scene, categories, has_attribute, size_share);
  std::vector<RequirementVerdict> verdicts;
  for (const auto& requirement : requirements) {
    Finding finding = checker.check(requirement);
    verdicts.push_back({requirement, finding.compliance, std::move(finding.reason)});
  }
  return verdicts;
}

}  // namespace roomgen
