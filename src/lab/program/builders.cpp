#include <utility>

#include "roomgen/lab/program.h"

namespace roomgen::lab::programs {

namespace {

ProgramSet source_of(ProgramSet::Source source, std::string name = {}) {
  ProgramSet set;
  set.source = source;
  set.name = std::move(name);
  return set;
}

// What can carry a description: the set itself if it is one, else one of its members.
ProgramSet described(ProgramSet set) {
  if (set.source == ProgramSet::Source::described) return set;
  ProgramSet result = source_of(ProgramSet::Source::described);
  if (set.source != ProgramSet::Source::objects) result.from.push_back(std::move(set));
  return result;
}

ProgramSet related(ProgramSet set, bool absent, std::string relation, ProgramSet target) {
  ProgramSet result = described(std::move(set));
  result.relations.push_back({absent, std::move(relation), {std::move(target)}});
  return result;
}

ProgramTerm over_members(ProgramOp op, std::string variable, ProgramSet set, ProgramTerm value) {
  ProgramTerm result = term(op, {std::move(set)}, {std::move(value)});
  result.name = std::move(variable);
  return result;
}

ProgramTerm weighted(ProgramOp op, double weight, ProgramTerm value) {
  ProgramTerm result = term(op, {}, {std::move(value)});
  result.number = weight;
  return result;
}

// a + b + c is one sum of three.
ProgramTerm chained(ProgramOp op, ProgramTerm a, ProgramTerm b) {
  if (a.op != op) return term(op, {}, {std::move(a), std::move(b)});
  a.operands.push_back(std::move(b));
  return a;
}

}  // namespace

ProgramSet things() { return source_of(ProgramSet::Source::objects); }
ProgramSet room() { return source_of(ProgramSet::Source::room); }
ProgramSet doors() { return source_of(ProgramSet::Source::doors); }
ProgramSet windows() { return source_of(ProgramSet::Source::windows); }
ProgramSet set(std::string name) { return source_of(ProgramSet::Source::named, std::move(name)); }
ProgramSet variable(std::string name) { return source_of(ProgramSet::Source::variable, std::move(name)); }

ProgramSet tagged(std::string tag) {
  ProgramSet result = source_of(ProgramSet::Source::described);
  result.tags.push_back(std::move(tag));
  return result;
}

ProgramSet of_kind(std::string factory) {
  ProgramSet result = source_of(ProgramSet::Source::described);
  result.factory = std::move(factory);
  return result;
}

ProgramSet among(ProgramSet of, ProgramSet description) {
  ProgramSet result = described(std::move(description));
  result.from.clear();
  if (of.source != ProgramSet::Source::objects) result.from.push_back(std::move(of));
  return result;
}

ProgramSet either(std::vector<ProgramSet> sets) {
  ProgramSet result = source_of(ProgramSet::Source::united);
  result.from = std::move(sets);
  return result;
}

ProgramSet with(ProgramSet set, std::string relation, ProgramSet target) {
  return related(std::move(set), false, std::move(relation), std::move(target));
}

ProgramSet without(ProgramSet set, std::string relation, ProgramSet target) {
  return related(std::move(set), true, std::move(relation), std::move(target));
}

ProgramTerm number(double value) {
  ProgramTerm result;
  result.number = value;
  return result;
}

ProgramTerm parameter(std::string name) {
  ProgramTerm result;
  result.op = ProgramOp::parameter;
  result.name = std::move(name);
  return result;
}

ProgramTerm term(ProgramOp op, std::vector<ProgramSet> sets, std::vector<ProgramTerm> operands) {
  ProgramTerm result;
  result.op = op;
  result.sets = std::move(sets);
  result.operands = std::move(operands);
  return result;
}

ProgramTerm count(ProgramSet set) { return term(ProgramOp::count, {std::move(set)}); }

ProgramTerm distance(ProgramSet from, ProgramSet to, std::optional<Face> face) {
  ProgramTerm result = term(ProgramOp::distance, {std::move(from), std::move(to)});
  result.face = face;
  return result;
}

ProgramTerm within(ProgramTerm value, double low, double high) {
  ProgramTerm result = term(ProgramOp::within, {}, {std::move(value)});
  result.literals = {low, high};
  return result;
}

ProgramTerm for_all(std::string variable, ProgramSet set, ProgramTerm truth) {
  return over_members(ProgramOp::for_all, std::move(variable), std::move(set), std::move(truth));
}

ProgramTerm mean(std::string variable, ProgramSet set, ProgramTerm value) {
  return over_members(ProgramOp::mean, std::move(variable), std::move(set), std::move(value));
}

ProgramTerm minimize(double weight, ProgramTerm value) {
  return weighted(ProgramOp::minimize, weight, std::move(value));
}

ProgramTerm maximize(double weight, ProgramTerm value) {
  return weighted(ProgramOp::maximize, weight, std::move(value));
}

ProgramTerm operator&&(ProgramTerm a, ProgramTerm b) {
  return chained(ProgramOp::all_of, std::move(a), std::move(b));
}

ProgramTerm operator||(ProgramTerm a, ProgramTerm b) {
  return chained(ProgramOp::any_of, std::move(a), std::move(b));
}

ProgramTerm operator+(ProgramTerm a, ProgramTerm b) {
  return chained(ProgramOp::add, std::move(a), std::move(b));
}

ProgramTerm operator-(ProgramTerm a, ProgramTerm b) {
  return term(ProgramOp::subtract, {}, {std::move(a), std::move(b)});
}

}  // namespace roomgen::lab::programs
