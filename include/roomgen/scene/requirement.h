#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// One clause of a prompt that can be checked on the finished room. Which members count depends on
/// the kind.
struct Requirement {
  enum class Kind {
    count,      ///< so many things of a kind
    attribute,  ///< its things, or the floor, walls or ceiling, are round, red, of oak
    relation,   ///< its things stand so to others or to a part of the room
    absence,    ///< no such things
  };
  Kind kind = Kind::count;
  std::string clause;                 ///< for people: "two nightstands", "laptop on desk"
  std::string category;               ///< of the things that it is about
  std::vector<std::string> subjects;  ///< their ids, as the plan has them
  int count = 1;                      ///< of Kind::count
  bool at_least = false;              ///< more are as good
  std::string attribute;              ///< of Kind::attribute, a word
  RelationKind relation = RelationKind::near;
  std::vector<std::string> targets;   ///< ids or parts of the room, of which one will do; none for
                                      ///< edge and middle
  std::string room;                   ///< id of the room that it is about, in a dwelling

  bool operator==(const Requirement&) const = default;
};

/// A requirement and whether the room meets it.
struct RequirementVerdict {
  Requirement requirement;
  bool met = false;
  std::string reason;  ///< why not, for people

  bool operator==(const RequirementVerdict&) const = default;
};

std::string_view name(Requirement::Kind kind);

/// {"clause", "kind", "category", "subjects", "count" | "attribute" | "relation", "targets"}
Json to_json(const Requirement& requirement);
/// That with "met" and "reason".
Json to_json(const RequirementVerdict& verdict);

}  // namespace roomgen
