#include "check_names.h"

#include <algorithm>

#include "form_operands.h"
#include "limits.h"
#include "names.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

bool is_in(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

template <typename Map>
std::vector<std::string> names_in(const Map& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

// What was built has no place in a file; where it belongs serves as well.
std::string place_of(const std::string& at, const std::string& outer) { return at.empty() ? outer : at; }

std::string quoted(const std::string& word) { return "\"" + word + "\""; }

}  // namespace

NameCheck::NameCheck(const ConstraintProgram& program, const KindTable& kinds, const ProgramVocabulary& vocabulary,
                     ProgramFindings& findings)
    : program_(program), kinds_(kinds), vocabulary_(vocabulary), findings_(findings),
      set_names_(names_in(program.sets)), relation_names_(names_in(built_in_relations())),
      parameter_names_(names_in(program.parameters)) {
  for (const auto& name : names_in(program.relations)) relation_names_.push_back(name);
  relation_names_.emplace_back("any");
}

void NameCheck::run() {
  check_named_sets();
  in_constraints_ = true;
  check_terms(program_.constraints, "/constraints/", true);
  in_constraints_ = false;
  check_terms(program_.scores, "/scores/", false);
}

void NameCheck::check_named_sets() {
  std::set<std::string> seen;
  for (const auto& [name, set] : program_.sets) {
    if (is_given_set(name) || !is_program_name(name) || !seen.insert(name).second)
      findings_.error("/sets/" + name, quoted(name) + " cannot name a set, or names another one too");
    check_set(set, "/sets/" + name, 0);
  }
}

void NameCheck::check_terms(const NamedTerms& terms, const std::string& place, bool truths) {
  for (const auto& [name, term] : terms) check_term(term, truths, place + name, 0);
}

void NameCheck::check_set(const ProgramSet& set, const std::string& outer, int depth) {
  if (findings_.full()) return;
  const std::string at = place_of(set.at, outer);
  if (depth > program_limits::set_depth) return findings_.error(at, "sets nested too deep; name some of them");
  switch (set.source) {
    case Source::named:
      if (!is_in(set_names_, set.name))
        findings_.error(at, "no set is called " + quoted(set.name) + suggestion(set.name, set_names_));
      break;
    case Source::variable:
      if (!is_in(variables_, set.name))
        findings_.error(at, "\"$" + set.name + "\" is no variable here" + suggestion(set.name, variables_));
      break;
    case Source::described: check_described(set, at, depth); break;
    case Source::united:
      if (set.from.empty()) findings_.error(at, "a union of no sets");
      for (const auto& member : set.from) check_set(member, at, depth + 1);
      break;
    default: break;
  }
}

void NameCheck::check_described(const ProgramSet& set, const std::string& at, int depth) {
  if (set.from.size() > 1) findings_.error(at, "a description chooses from one set; unite them");
  for (const auto& from : set.from) check_set(from, at, depth + 1);
  for (const auto& tag : set.tags) check_tag(tag, at);
  for (const auto& tag : set.without) check_tag(tag, at);
  if (!set.factory.empty()) check_factory(set.factory, at);
  for (const auto& relation : set.relations) check_relation(relation, at, depth);
}

void NameCheck::check_tag(const std::string& tag, const std::string& at) {
  if (vocabulary_.tags.contains(tag)) return;
  const bool made = vocabulary_.factories.contains(tag) || kinds_.by_name(tag);
  findings_.error(at, quoted(tag) + " is no tag" +
                          (made ? "; say {\"factory\": " + quoted(tag) + "}" : suggestion(tag, names_in(vocabulary_.tags))));
}

void NameCheck::check_factory(const std::string& factory, const std::string& at) {
  std::string name = factory;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (vocabulary_.factories.contains(factory) || kinds_.by_name(name)) return;
  std::vector<std::string> known = names_in(vocabulary_.factories);
  for (const auto& [kind, entry] : kinds_.all()) known.push_back(kind);
  const std::string hint = vocabulary_.tags.contains(factory) ? "; say {\"tags\": [" + quoted(factory) + "]}"
                                                              : suggestion(factory, known);
  findings_.error(at, quoted(factory) + " is no factory and no kind of thing" + hint);
}

void NameCheck::check_relation(const SetRelation& relation, const std::string& at, int depth) {
  if (!is_in(relation_names_, relation.relation))
    findings_.error(at, "no relation is called " + quoted(relation.relation) +
                            suggestion(relation.relation, relation_names_));
  if (relation.target.size() != 1) findings_.error(at, quoted(relation.relation) + " has no target");
  for (const auto& target : relation.target) check_set(target, at, depth + 1);
}

void NameCheck::check_term(const ProgramTerm& term, bool truth, const std::string& outer, int depth) {
  if (findings_.full()) return;
  const std::string at = place_of(term.at, outer);
  if (depth > program_limits::term_depth) return findings_.error(at, "terms nested too deep; part them");
  if (term.op == ProgramOp::constant || term.op == ProgramOp::parameter) {
    if (truth) findings_.error(at, "a number where something must hold; compare it with another one");
    if (term.op == ProgramOp::parameter && !is_in(parameter_names_, term.name))
      findings_.error(at, "no parameter is called " + quoted(term.name) + suggestion(term.name, parameter_names_));
    return;
  }
  const auto& form = form_of(term.op);
  if (form.truth && !truth)
    findings_.error(at, quoted(std::string(form.name)) + " holds or not, and a number is needed here" +
                            (term.op == ProgramOp::for_all ? "; say mean or sum" : ""));
  else if (!form.truth && truth)
    findings_.error(at, quoted(std::string(form.name)) + " gives a number where something must hold; compare it with "
                        "another one");
  check_operation(term, at, depth);
}

// The operands' number; what an operand is, is checked with the operand.
bool NameCheck::has_its_operands(const ProgramTerm& term, const std::string& at) {
  const auto& form = form_of(term.op);
  const auto wanted = [&](std::string_view sorts) {
    return static_cast<std::size_t>(std::count_if(form.operands.begin(), form.operands.end(), [&](char c) {
      return sorts.find(c) != std::string_view::npos;
    }));
  };
  const bool repeated = form.operands.back() == '+';
  const std::size_t literals = is_weighted(term.op) ? 0 : wanted("L"), operands = wanted("NB");
  const bool fits = term.sets.size() == wanted("S") && term.literals.size() == literals &&
                    (repeated ? term.operands.size() >= operands : term.operands.size() == operands);
  if (!fits) findings_.error(at, "not the operands of " + usage(form));
  return fits;
}

void NameCheck::check_literals(const ProgramTerm& term, const std::string& at) {
  if (term.literals.size() == 2 && term.literals[0] > term.literals[1])
    findings_.error(at, "the lower bound is above the upper one");
  const auto is_zero = [](const ProgramTerm& operand) {
    return operand.op == ProgramOp::constant && operand.number == 0.0;
  };
  if (term.op == ProgramOp::divide && is_zero(term.operands[1])) findings_.error(at, "a division by zero");
  if (is_weighted(term.op) && in_constraints_)
    findings_.error(at, "what is wanted small or large belongs in the scores; constraints hold or not");
}

void NameCheck::check_variable(const ProgramTerm& term, const std::string& at) {
  if (!is_program_name(term.name)) findings_.error(at, quoted(term.name) + " cannot name a variable");
  if (is_in(variables_, term.name))
    findings_.error(at, quoted(term.name) + " is a variable here already; take another name");
  if (variables_.size() == program_limits::variables)
    findings_.error(at, "more than " + std::to_string(program_limits::variables) +
                            " variables at one place; nest fewer of all, mean and sum");
}

void NameCheck::check_operation(const ProgramTerm& term, const std::string& at, int depth) {
  if (!has_its_operands(term, at)) return;
  check_literals(term, at);
  for (const auto& set : term.sets) check_set(set, at, 0);
  const auto& form = form_of(term.op);
  const bool binds = form.operands.front() == 'v';
  if (binds) {
    check_variable(term, at);
    variables_.push_back(term.name);
  }
  const bool truths = form.operands.find('B') != std::string_view::npos;
  for (const auto& operand : term.operands) check_term(operand, truths, at, depth + 1);
  if (binds) variables_.pop_back();
}

}  // namespace roomgen::lab
