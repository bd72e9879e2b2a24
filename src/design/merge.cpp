#include "merge.h"

#include <algorithm>

namespace roomgen::design {

namespace {

// Two relations of one group say the same sort of thing; only one of them can lead.
enum class Group { wall, distance, position, alignment, facing, support };

Group group(RelationKind kind) {
  switch (kind) {
    case RelationKind::edge:
    case RelationKind::middle:
    case RelationKind::corner:
      return Group::wall;
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::far:
      return Group::distance;
    case RelationKind::in_front_of:
    case RelationKind::behind:
    case RelationKind::left_of:
    case RelationKind::right_of:
    case RelationKind::side_of:
    case RelationKind::around:
      return Group::position;
    case RelationKind::center_aligned:
    case RelationKind::aligned:
      return Group::alignment;
    case RelationKind::face_to:
    case RelationKind::face_same_as:
    case RelationKind::face_opposite_to:
      return Group::facing;
    case RelationKind::on:
    case RelationKind::inside:
    case RelationKind::above:
    case RelationKind::under:
    case RelationKind::hang_from:
      break;
  }
  return Group::support;
}

bool places(const Relation& relation) {
  const Group g = group(relation.kind);
  return !relation.target.empty() && relation.kind != RelationKind::far &&
         (g == Group::distance || g == Group::position || g == Group::support);
}

bool contradicts(const Relation& asked, const Relation& habit) {
  if (group(asked.kind) == group(habit.kind)) return true;
  if (group(habit.kind) == Group::wall) return asked.kind == RelationKind::on;
  // Once its place is asked, habits about other things have no say, nor those that place it anew.
  if (places(asked)) return asked.target != habit.target || group(habit.kind) != Group::facing;
  // At a wall nobody stands around a table.
  return group(asked.kind) == Group::wall && habit.kind == RelationKind::around;
}

}  // namespace

std::vector<Relation> compatible_habits(const std::vector<Relation>& asked,
                                        const std::vector<Relation>& habits) {
  std::vector<Relation> kept;
  for (const auto& habit : habits)
    if (std::none_of(asked.begin(), asked.end(),
                     [&](const Relation& relation) { return contradicts(relation, habit); }))
      kept.push_back(habit);
  return kept;
}

}  // namespace roomgen::design
