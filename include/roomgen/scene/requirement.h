#pragma once

#include <cstddef>
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
    room,       ///< the room itself: its kind, its sides, its height, how many windows
    each,       ///< so many of its things for each of the targets, each its own
    only,       ///< nothing but its things: of a kind, on a target, or at all
  };
  /// Who asked for it.
  enum class Source { prompt, model, edit, person, activity };

  std::string id;  ///< unique in its scene; stays through edits
  Kind kind = Kind::count;
  Source source = Source::prompt;
  std::string clause;                 ///< for people: "two nightstands", "laptop on desk"
  std::string category;               ///< of the things that it is about
  std::vector<std::string> subjects;  ///< their ids, as the plan has them
  int count = 1;                      ///< of Kind::count; of Kind::each for each
  int most = 0;                       ///< of Kind::count: "8 to 12" has 8 and 12; 0: just `count`
  bool at_least = false;              ///< more are as good
  bool at_most = false;               ///< fewer or less are as good
  bool denied = false;                ///< of Kind::relation: none of its things stands so
  std::string attribute;              ///< of Kind::attribute, a word; of Kind::room what of it, as
                                      ///< docs/requirements.md lists them
  double amount = 0.0;                ///< of Kind::room: metres, square metres, a number; of a
                                      ///< length of things and of RelationKind::gap: metres
  RelationKind relation = RelationKind::near;
  std::vector<std::string> targets;   ///< ids or parts of the room, of which one will do; none for
                                      ///< edge and middle
  std::string room;                   ///< id of the room that it is about, in a dwelling
  int picture = 0;                    ///< which of the wish's shows it; 0: words say it

  bool operator==(const Requirement&) const = default;
};

/// The attribute of things that stand in `count` rows; 0: however many.
inline constexpr std::string_view in_rows = "in rows";
/// Those of things that stand around a point, all the way or open on one side.
inline constexpr std::string_view in_circle = "in a circle", in_arc = "in an arc", in_islands = "in islands";

/// That of things that hang so high: `amount` is between their bottom and their top.
inline constexpr std::string_view height_above_floor = "height above the floor";

/// What becomes of a requirement.
enum class Compliance {
  met,
  not_met,
  not_judged,  ///< nothing shows whether it is met
  withdrawn,   ///< by an edit
};

/// A requirement and whether the room meets it.
struct RequirementVerdict {
  Requirement requirement;
  Compliance compliance = Compliance::not_met;
  std::string reason;  ///< why not, for people

  bool met() const { return compliance == Compliance::met; }

  bool operator==(const RequirementVerdict&) const = default;
};

std::string_view name(Requirement::Kind kind);
std::string_view name(Requirement::Source source);
/// "met", "not met", "cannot be judged", "withdrawn"
std::string_view name(Compliance compliance);

/// A run of words of a prompt, and what it was taken for. Every word of a prompt that is no mere
/// function word ("the", "is", "of") is heard as something, if only as not understood.
struct Heard {
  enum class As {
    thing,
    count,
    attribute,
    relation,
    room,
    style,
    person,
    activity,
    absence,
    not_understood
  };

  std::size_t begin = 0, end = 0;  ///< bytes of the prompt: the first, and one past the last
  std::string text;                ///< as written
  As as = As::not_understood;
  std::vector<std::string> requirements;  ///< ids of what it is checked by

  bool operator==(const Heard&) const = default;
};

/// "not understood"
std::string_view name(Heard::As as);

/// Its clause for people, with the picture that shows it: "a desk (image 1)".
std::string told(const Requirement& requirement);
/// What became of it: "r7: 2 red chair: not met, there is 1 instead of 2".
std::string told(const RequirementVerdict& verdict);

/// {"id", "clause", "kind", "source", "category", "subjects", "count" | "attribute" | "relation", ...}
Json to_json(const Requirement& requirement);
/// That with "verdict", "met" and "reason".
Json to_json(const RequirementVerdict& verdict);

/// A list in the order of the text: {"span": [0, 5], "text", "as", "requirements"}.
Json to_json(const std::vector<Heard>& heard);

}  // namespace roomgen
