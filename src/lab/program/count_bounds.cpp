#include <cmath>
#include <limits>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
using Variables = std::vector<std::pair<std::string, const ProgramSet*>>;

// What a count may be so that it compares so to a number.
std::optional<Range> range_of(ProgramOp op, double number) {
  switch (op) {
    case ProgramOp::equal: return Range{number, number};
    case ProgramOp::at_least: return Range{std::ceil(number), unbounded};
    case ProgramOp::more: return Range{std::floor(number) + 1.0, unbounded};
    case ProgramOp::at_most: return Range{0.0, std::floor(number)};
    case ProgramOp::less: return Range{0.0, std::ceil(number) - 1.0};
    default: return std::nullopt;
  }
}

ProgramOp turned_round(ProgramOp op) {
  switch (op) {
    case ProgramOp::at_least: return ProgramOp::at_most;
    case ProgramOp::at_most: return ProgramOp::at_least;
    case ProgramOp::more: return ProgramOp::less;
    case ProgramOp::less: return ProgramOp::more;
    default: return op;
  }
}

bool counts_a_set(const ProgramTerm& term) { return term.op == ProgramOp::count && term.sets.size() == 1; }
bool is_number(const ProgramTerm& term) { return term.op == ProgramOp::constant; }

void add_bound(const ProgramTerm& counted, const Range& range, const Variables& variables,
               std::vector<CountBound>& bounds) {
  bounds.push_back({&counted.sets[0], std::max(0.0, range.low), range.high, variables});
}

void add_comparison(const ProgramTerm& term, const Variables& variables, std::vector<CountBound>& bounds) {
  if (term.operands.size() != 2) return;
  const auto& a = term.operands[0];
  const auto& b = term.operands[1];
  if (counts_a_set(a) && is_number(b)) {
    if (const auto range = range_of(term.op, b.number)) add_bound(a, *range, variables, bounds);
  } else if (is_number(a) && counts_a_set(b)) {
    if (const auto range = range_of(turned_round(term.op), a.number)) add_bound(b, *range, variables, bounds);
  }
}

void add_within(const ProgramTerm& term, const Variables& variables, std::vector<CountBound>& bounds) {
  if (term.operands.size() != 1 || term.literals.size() != 2 || !counts_a_set(term.operands[0])) return;
  const Range range{std::ceil(term.literals[0]), std::floor(term.literals[1])};
  add_bound(term.operands[0], range, variables, bounds);
}

void add_bounds(const ProgramTerm& term, Variables& variables, std::vector<CountBound>& bounds) {
  switch (term.op) {
    case ProgramOp::all_of:
      for (const auto& operand : term.operands) add_bounds(operand, variables, bounds);
      break;
    case ProgramOp::for_all:
      if (term.sets.size() != 1 || term.operands.size() != 1) break;
      variables.emplace_back(term.name, &term.sets[0]);
      add_bounds(term.operands[0], variables, bounds);
      variables.pop_back();
      break;
    case ProgramOp::within: add_within(term, variables, bounds); break;
    default: add_comparison(term, variables, bounds);
  }
}

}  // namespace

std::vector<CountBound> count_bounds(const ConstraintProgram& program) {
  std::vector<CountBound> bounds;
  Variables variables;
  for (const auto& [name, term] : program.constraints) add_bounds(term, variables, bounds);
  return bounds;
}

}  // namespace roomgen::lab
