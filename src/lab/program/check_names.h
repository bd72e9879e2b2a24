#pragma once

#include <set>
#include <string>
#include <vector>

#include "findings.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// Looks at every word and every place of a program: names that nobody knows, numbers where truths belong,
/// too few or too many operands, too much nesting.
class NameCheck {
 public:
  /// All must outlive this.
  NameCheck(const ConstraintProgram& program, const KindTable& kinds, const ProgramVocabulary& vocabulary,
            ProgramFindings& findings);

  void run();

 private:
  void check_named_sets();
  void check_terms(const NamedTerms& terms, const std::string& place, bool truths);
  void check_set(const ProgramSet& set, const std::string& outer, int depth);
  void check_described(const ProgramSet& set, const std::string& at, int depth);
  void check_tag(const std::string& tag, const std::string& at);
  void check_factory(const std::string& factory, const std::string& at);
  void check_relation(const SetRelation& relation, const std::string& at, int depth);
  void check_term(const ProgramTerm& term, bool truth, const std::string& outer, int depth);
  void check_operation(const ProgramTerm& term, const std::string& at, int depth);
  bool has_its_operands(const ProgramTerm& term, const std::string& at);
  void check_literals(const ProgramTerm& term, const std::string& at);
  void check_variable(const ProgramTerm& term, const std::string& at);

  const ConstraintProgram& program_;
  const KindTable& kinds_;
  const ProgramVocabulary& vocabulary_;
  ProgramFindings& findings_;
  std::vector<std::string> set_names_, relation_names_, parameter_names_;
  std::vector<std::string> variables_;  ///< in force, outermost first
  bool in_constraints_ = false;
};

/// Sets that name each other in a circle.
void check_circles(const ConstraintProgram& program, ProgramFindings& findings);

}  // namespace roomgen::lab
