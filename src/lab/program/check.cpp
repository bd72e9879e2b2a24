#include "check_names.h"
#include "check_rules.h"
#include "findings.h"
#include "set_kinds.h"

namespace roomgen::lab {

namespace {

void check_range(const std::optional<Range>& range, const std::string& at, ProgramFindings& findings) {
  if (range && range->low > range->high) findings.error(at, "the lower end is above the upper one");
}

void check_ranges(const ConstraintProgram& program, ProgramFindings& findings) {
  check_range(program.room.width, "/room/width", findings);
  check_range(program.room.depth, "/room/depth", findings);
  check_range(program.room.area, "/room/area", findings);
  for (const auto& [name, parameter] : program.parameters) {
    check_range(parameter.uniform, "/params/" + name, findings);
    if (!parameter.uniform && parameter.choice.empty()) findings.error("/params/" + name, "a choice of nothing");
  }
}

void check_relations(const ConstraintProgram& program, ProgramFindings& findings) {
  for (const auto& [name, put_up] : program.relations) {
    if (built_in_relations().contains(name) || name == "any")
      findings.error("/relations/" + name, "\"" + name + "\" is built in; take another name");
    if (put_up.child.empty() || put_up.parent.empty())
      findings.error("/relations/" + name, "no face of the child or none of the parent");
  }
}

}  // namespace

std::vector<ProgramFinding> check(const ConstraintProgram& program, const KindTable& kinds,
                                  const ProgramVocabulary& vocabulary) {
  ProgramFindings findings;
  check_ranges(program, findings);
  check_relations(program, findings);
  NameCheck(program, kinds, vocabulary, findings).run();
  check_circles(program, findings);
  // What a set means is known when all that it names is.
  if (findings.has_errors()) return findings.take();
  SetKinds set_kinds(program, kinds, vocabulary);
  check_members(program, set_kinds, findings);
  check_counts(program, set_kinds, findings);
  check_work(program, set_kinds, findings);
  return findings.take();
}

}  // namespace roomgen::lab
