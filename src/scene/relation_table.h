#pragma once

#include <array>
#include <span>
#include <string_view>

#include "judgement.h"
#include "resolved_relation.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// What sort of thing a relation says: of several of one sort only one can lead.
enum class RelationSort { wall, region, distance, position, alignment, facing, support };

/// What a relation is asked about: a pose of the object, and one of the relation's targets.
struct RelationCase {
  const ResolvedRelation& relation;
  const Subject& subject;
  const Footprint& target;
  const Room& room;

  const Footprint& own() const { return subject.footprint; }
};

/// All that is to be known of a relation. A new one is an enumerator of RelationKind, a row of this table and a
/// line of docs/constraints.md.
struct RelationDefinition {
  enum Trait : unsigned {
    none = 0,
    targeted = 1,    ///< it has a target
    beside = 2,      ///< poses beside the target, at useful gaps and flush with its ends, are worth trying
    in_prompts = 4,  ///< prompts say it by its name; data/words.json has further phrases
  };

  RelationKind kind;
  RelationSort sort;
  unsigned traits;
  Judgement (*judge)(const RelationCase&);
  std::array<std::string_view, 6> spellings;  ///< its name and how else files may spell it; the rest is empty

  std::string_view name() const { return spellings.front(); }
  bool has(Trait trait) const { return (traits & trait) != 0; }
};

/// In the order of the enumerators.
std::span<const RelationDefinition> relation_definitions();
const RelationDefinition& definition(RelationKind kind);

}  // namespace roomgen
