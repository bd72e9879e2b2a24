#include "compatible.h"

#include <algorithm>

namespace roomgen {

namespace {

// Two relations of one group say the same sort of thing; only one of them can lead.
enum class RelationGroup { wall, region, distance, position, alignment, facing, support };

RelationGroup group(RelationKind kind) {
  switch (kind) {
    case RelationKind::edge:
    case RelationKind::middle:
    case RelationKind::corner:
      return RelationGroup::wall;
    case RelationKind::in_part:
      return RelationGroup::region;
    case RelationKind::near:
    case RelationKind::next_to:
    case RelationKind::far:
      return RelationGroup::distance;
    case RelationKind::in_front_of:
    case RelationKind::behind:
    case RelationKind::left_of:
    case RelationKind::right_of:
    case RelationKind::side_of:
    case RelationKind::around:
    case RelationKind::between:
      return RelationGroup::position;
    case RelationKind::center_aligned:
    case RelationKind::aligned:
      return RelationGroup::alignment;
    case RelationKind::face_to:
    case RelationKind::face_same_as:
    case RelationKind::face_opposite_to:
      return RelationGroup::facing;
    case RelationKind::on:
    case RelationKind::inside:
    case RelationKind::above:
    case RelationKind::under:
    case RelationKind::hang_from:
      break;
  }
  return RelationGroup::support;
}

bool places(const Relation& relation) {
  const RelationGroup g = group(relation.kind);
  return !relation.target.empty() && relation.kind != RelationKind::far &&
         (g == RelationGroup::distance || g == RelationGroup::position || g == RelationGroup::support);
}

bool contradicts(const Relation& asked, const Relation& habit) {
  if (group(asked.kind) == group(habit.kind)) return true;
  if (group(habit.kind) == RelationGroup::wall) return asked.kind == RelationKind::on;
  // Once its place is asked, habits about other things have no say, nor those that place it anew.
  if (places(asked)) return asked.target != habit.target || group(habit.kind) != RelationGroup::facing;
  // At a wall nobody stands around a table.
  return group(asked.kind) == RelationGroup::wall && habit.kind == RelationKind::around;
}

}  // namespace

std::vector<Relation> compatible_with(const std::vector<Relation>& asked,
                                        const std::vector<Relation>& habits) {
  std::vector<Relation> kept;
  for (const auto& habit : habits)
    if (std::none_of(asked.begin(), asked.end(),
                     [&](const Relation& relation) { return contradicts(relation, habit); }))
      kept.push_back(habit);
  return kept;
}

}  // namespace roomgen
