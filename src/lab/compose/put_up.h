#pragma once

#include <functional>
#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/relation.h"

namespace roomgen::lab::compose {

/// How things are put up and what is good for them, as parts of a program.
struct Habits {
  std::vector<SetRelation> relations;  ///< of their set, three at most
  std::vector<ProgramTerm> scores;
  std::vector<ProgramTerm> truths;     ///< what was asked for
  std::vector<std::string> unsaid;     ///< relations that programs have no words for
};

/// What things are, that relations are said of.
struct Subject {
  const Kind& kind;
  Mount mount = Mount::floor;
  std::string set;  ///< of the program
  bool is_single = true;  ///< there is one of it at most
};

/// The set that a relation's target means, and the kind of its members, if there are any such things.
struct TargetSet {
  ProgramSet set;
  const Kind* kind = nullptr;  ///< null: a part of the room
  bool comes_before = true;    ///< its members are described without the subject's: they may carry or gather them
};
using FindTarget = std::function<std::optional<TargetSet>(const std::string& target)>;

/// The floor, wall, ceiling or thing that carries a thing of this mount. `carrier` is only used for what stands on
/// things.
SetRelation carried_by(Mount mount, const ProgramSet& carrier);

/// Relations in the grammar of scenes, as parts of a program: what fixes a place against something becomes a way
/// of being put up, the rest scores, or truths if it is `asked`.
Habits habits_of(const std::vector<Relation>& relations, const Subject& subject, const FindTarget& target, bool asked);

}  // namespace roomgen::lab::compose
