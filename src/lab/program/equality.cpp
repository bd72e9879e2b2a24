#include <tuple>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

namespace {

auto meaning(const SetRelation& relation) { return std::tie(relation.absent, relation.relation, relation.target); }

auto meaning(const ProgramSet& set) {
  return std::tie(set.source, set.name, set.from, set.tags, set.without, set.factory, set.relations);
}

auto meaning(const ProgramTerm& term) {
  return std::tie(term.op, term.number, term.name, term.sets, term.operands, term.literals, term.face, term.direction,
                  term.depth);
}

}  // namespace

bool SetRelation::operator==(const SetRelation& other) const { return meaning(*this) == meaning(other); }
bool ProgramSet::operator==(const ProgramSet& other) const { return meaning(*this) == meaning(other); }
bool ProgramTerm::operator==(const ProgramTerm& other) const { return meaning(*this) == meaning(other); }

}  // namespace roomgen::lab
