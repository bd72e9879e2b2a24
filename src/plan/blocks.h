#pragma once

#include <string>
#include <vector>

#include "composition/arrange.h"
#include "inventory.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// The part of a block that each of its things is, that which they stand around, and that which one has behind it.
inline constexpr const char* block_unit = "unit";
inline constexpr const char* block_focus = "focus";
inline constexpr const char* block_behind = "behind";

/// Many of a kind that are told to stand in rows, in a circle or in an arc, each with what belongs to it, or one with what
/// is told to be at it: a composition of its own, which a plan's group brings along (docs/groups.md).
struct FormedBlock {
  brief::Formation formation;
  int count = 0;
  Draft thing;               ///< one of them
  std::string composition = {};   ///< of one with what belongs to it; empty: the thing alone
  composition::Values with = {};  ///< its parameters
  std::string anchor = block_unit;  ///< the part that the thing itself is
  std::string behind = {};  ///< the kind at whose front one thing stands, with room for its sitter between; empty: none
  std::vector<Draft> companions = {};  ///< told to be at each of them, in that quantity; for each a part of its item's
  std::string group = {};        ///< its id
  bool has_focus = false;        ///< what they stand around is of the group
  std::string focus_kind = {};
  bool looks_over = false;   ///< who uses it looks over its back: a desk
};

/// The drafts that are told to be at each of `count` things of one, as many at each.
std::vector<std::size_t> told_companions(const Draft& thing, int count, const std::vector<Draft>& drafts,
                                         const KindTable& kinds);

/// How many parts of a block its things are, one after the other: each place of an island is one of its own.
int places_of(const FormedBlock& block);
std::string unit_name(int place);

/// Its composition, as JSON. Its parameter "open" is the share of the floor that should be between its things, rows
/// have "columns".
std::string definition_of(const FormedBlock& block, const KindTable& kinds, const Arrangements& arrangements);

/// Says where a block stands in its room and which way its things look: with their fronts to the wall that is told, to
/// what they look at, or to one without doors and windows; as loose as there is room for. What they look at goes to that
/// wall unless it was told where. Other things have the floor behind it, if there are many. A single row and what stands
/// around something or is one alone are left to what is said of their place.
void stand_in_room(const FormedBlock& block, const KindTable& kinds, const Room& room, std::vector<Draft>& drafts,
                   PlanGroup& group);

/// Whether it says of a thing that it is at another, as the patterns of compositions put it.
bool is_place_at(RelationKind kind);

/// Which says at which side of it, too.
bool is_place_at_side(RelationKind kind);

/// How many things stand in each row of so many.
std::size_t columns_of(const brief::Formation& formation, std::size_t count);

}  // namespace roomgen::plan
