#include <algorithm>

#include "check_rules.h"
#include "face_names.h"

namespace roomgen::lab {

namespace {

void check_face(const ProgramTerm& term, const SetKinds& kinds, ProgramFindings& findings) {
  if (!term.face || term.sets.size() != 2) return;
  const bool room = kinds.is_room(term.sets[1]);
  const std::string face(name(*term.face));
  if (room && !is_of_room(*term.face))
    findings.error(term.at, "the room has no " + face + "; it has wall, floor and ceiling");
  if (!room && is_of_room(*term.face))
    findings.error(term.at, "\"" + to_text(term.sets[1]) + "\" has no " + face + ", the room has");
}

void check_term(const ProgramTerm& term, SetKinds& kinds, ProgramFindings& findings) {
  if (findings.full()) return;
  check_face(term, kinds, findings);
  const bool binds = !term.name.empty() && term.sets.size() == 1;
  if (binds) {
    if (kinds.is_empty(term.sets[0]))
      findings.warn(term.sets[0].at, "no kind of thing is \"" + to_text(term.sets[0]) + "\", so this says nothing");
    kinds.bind(term.name, term.sets[0]);
  }
  for (const auto& operand : term.operands) check_term(operand, kinds, findings);
  if (binds) kinds.unbind();
}

bool says_what_is_wanted(const ProgramTerm& term) {
  if (term.op == ProgramOp::minimize || term.op == ProgramOp::maximize) return true;
  return std::any_of(term.operands.begin(), term.operands.end(), says_what_is_wanted);
}

}  // namespace

void check_members(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings) {
  for (const auto& [name, term] : program.constraints) check_term(term, kinds, findings);
  for (const auto& [name, term] : program.scores) {
    check_term(term, kinds, findings);
    if (!says_what_is_wanted(term))
      findings.warn("/scores/" + name, "nothing says whether it is wanted small or large; say minimize or maximize");
  }
}

}  // namespace roomgen::lab
