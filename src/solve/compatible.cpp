#include "compatible.h"

#include <algorithm>
#include <cmath>

#include "scene/relation_table.h"
#include "scene/room_part.h"

namespace roomgen {

namespace {

RelationSort sort(const Relation& relation) {
  return definition(relation.kind).sort;
}

bool is_wall(const std::string& target) { return target == nearest_wall || target.starts_with("wall-"); }

bool contradicts(const Relation& asked, const Relation& habit) {
  if (sort(asked) == sort(habit)) return true;
  // What keeps its distance from a wall is not at one.
  if (asked.kind == RelationKind::gap && is_wall(asked.target) && sort(habit) == RelationSort::wall) return true;
  if (sort(habit) == RelationSort::wall) return asked.kind == RelationKind::on;
  // Once its place is asked, habits about other things have no say, nor those that place it anew.
  if (places(asked)) return asked.target != habit.target || sort(habit) != RelationSort::facing;
  // At a wall nobody stands around a table.
  return sort(asked) == RelationSort::wall && habit.kind == RelationKind::around;
}

}  // namespace

bool places(const Relation& relation) {
  const RelationSort what = sort(relation);
  const bool keeps_away = relation.kind == RelationKind::far || (relation.kind == RelationKind::gap && std::isinf(relation.gap.most));
  return !relation.target.empty() && !keeps_away &&
         (what == RelationSort::distance || what == RelationSort::position || what == RelationSort::support);
}

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
