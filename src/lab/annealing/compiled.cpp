#include "compiled.h"

#include <algorithm>

namespace roomgen::lab::annealing {

namespace {

bool covers(const std::vector<Face>& general, Face face) {
  return std::ranges::any_of(general, [&](Face other) {
    return other == face || (other == Face::support && face == Face::top);
  });
}

bool covers(const std::vector<Face>& general, const std::vector<Face>& special) {
  return std::ranges::all_of(special, [&](Face face) { return covers(general, face); });
}

std::vector<Face> directions_of(const std::string& direction) {
  if (direction == "sides") return {Face::left, Face::right};
  if (direction == "back") return {Face::back};
  if (direction == "left") return {Face::left};
  if (direction == "right") return {Face::right};
  if (direction == "up") return {Face::top};
  if (direction == "down") return {Face::bottom};
  return {Face::front};
}

Language language_of(const ConstraintProgram& program) {
  Language language;
  const auto add = [&](const std::string& name, const PutUp& how) {
    language.names.push_back(name);
    language.relations.push_back(how);
  };
  for (const auto& [name, how] : program.relations) add(name, how);
  for (const auto& [name, how] : built_in_relations())
    if (!program.relations.contains(name)) add(name, how);
  return language;
}

// Does it say the same wherever things are, as long as they are the same, put up against the same?
bool is_structural(const TermNode& term) {
  switch (term.op) {
    case ProgramOp::footprint: case ProgramOp::area: case ProgramOp::occupancy: case ProgramOp::distance:
    case ProgramOp::gap: case ProgramOp::access: case ProgramOp::angle: case ProgramOp::focus: case ProgramOp::center:
    case ProgramOp::reflection: case ProgramOp::rotation: case ProgramOp::coplanarity: return false;
    default: return std::ranges::all_of(term.operands, is_structural);
  }
}

// The largest such parts of a term that no variable is in force for.
void number_structural(TermNode& term, int& count) {
  if (term.op == ProgramOp::constant) return;
  if (is_structural(term)) term.structure_memo = count++;
  else if (term.variable < 0)
    for (auto& operand : term.operands) number_structural(operand, count);
}

}  // namespace

int Language::number_of(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

bool implies(const PutUp& special, const PutUp& general) {
  return special.type == general.type && covers(general.child, special.child) &&
         covers(general.parent, special.parent) && special.margin == general.margin;
}

Compiler::Compiler(const ConstraintProgram& program, const std::vector<const Kind*>& kinds, const KindTable& table,
                   const ProgramVocabulary& vocabulary, Random random)
    : program_(program), kinds_(kinds), table_(table), vocabulary_(vocabulary) {
  result_.language = language_of(program);
  for (const auto& [name, parameter] : program.parameters) {
    Random own = random.fork(name);
    if (parameter.uniform) parameters_[name] = own.uniform(parameter.uniform->low, parameter.uniform->high);
    else if (!parameter.choice.empty()) parameters_[name] = own.pick(parameter.choice);
  }
}

void Compiler::compile() {
  for (const auto& [name, term] : program_.constraints)
    result_.constraints.push_back({name, this->term(term, {}), to_text(term)});
  for (const auto& [name, term] : program_.scores)
    result_.scores.push_back({name, this->term(term, {}), to_text(term)});
  for (auto* terms : {&result_.constraints, &result_.scores})
    for (auto& named : *terms) number_structural(named.term, result_.structure_memos);
}

int Compiler::filter(const ProgramSet& set) {
  if (set.tags.empty() && set.without.empty() && set.factory.empty()) return -1;
  KindFilter filter;
  for (const Kind* kind : kinds_) {
    const auto has = [&](const std::string& tag) { return has_tag(vocabulary_, *kind, tag); };
    filter.passes.push_back(std::ranges::all_of(set.tags, has) && std::ranges::none_of(set.without, has) &&
                            (set.factory.empty() || is_made_by(vocabulary_, table_, *kind, set.factory)));
  }
  result_.filters.push_back(std::move(filter));
  return static_cast<int>(result_.filters.size()) - 1;
}

SetNode::Relation Compiler::relation(const SetRelation& relation, const std::vector<std::string>& scope) {
  SetNode::Relation node;
  node.absent = relation.absent;
  const auto& known = result_.language.relations;
  const int own = result_.language.number_of(relation.relation);
  for (std::size_t i = 0; i < known.size(); ++i)
    node.kinds.push_back(own < 0 || implies(known[i], known[static_cast<std::size_t>(own)]));
  if (own >= 0) node.wanted.push_back(own);
  node.target = set(relation.target.front(), scope);
  return node;
}

int Compiler::described(const ProgramSet& set, const std::vector<std::string>& scope) {
  SetNode node;
  node.source = set.source;
  for (const auto& from : set.from) node.from.push_back(this->set(from, scope));
  node.filter = filter(set);
  for (const auto& relation : set.relations) node.relations.push_back(this->relation(relation, scope));
  for (const int from : node.from)
    node.is_closed = node.is_closed && result_.sets[static_cast<std::size_t>(from)].is_closed;
  for (const auto& relation : node.relations)
    node.is_closed = node.is_closed && result_.sets[static_cast<std::size_t>(relation.target)].is_closed;
  result_.sets.push_back(std::move(node));
  return static_cast<int>(result_.sets.size()) - 1;
}

int Compiler::set(const ProgramSet& set, const std::vector<std::string>& scope) {
  using Source = ProgramSet::Source;
  if (set.source == Source::described || set.source == Source::united) return described(set, scope);
  if (set.source == Source::named) {
    if (const auto known = named_.find(set.name); known != named_.end()) return known->second;
    const auto found = std::ranges::find(program_.sets, set.name, &NamedSets::value_type::first);
    return named_[set.name] = this->set(found->second, {});
  }
  SetNode node;
  node.source = set.source;
  if (set.source == Source::variable) {
    const auto at = std::find(scope.rbegin(), scope.rend(), set.name);
    node.variable = static_cast<int>(scope.rend() - at) - 1;
    node.is_closed = false;
  }
  result_.sets.push_back(std::move(node));
  return static_cast<int>(result_.sets.size()) - 1;
}

TermNode Compiler::term(const ProgramTerm& term, std::vector<std::string> scope) {
  TermNode node;
  node.op = term.op;
  node.number = term.number;
  if (term.op == ProgramOp::parameter) node.op = ProgramOp::constant, node.number = parameters_[term.name];
  for (const auto& set : term.sets) node.sets.push_back(this->set(set, scope));
  if (term.op == ProgramOp::for_all || term.op == ProgramOp::mean || term.op == ProgramOp::sum) {
    node.variable = static_cast<int>(scope.size());
    scope.push_back(term.name);
  }
  for (const auto& operand : term.operands) node.operands.push_back(this->term(operand, scope));
  if (term.literals.size() > 1) node.low = term.literals[0], node.high = term.literals[1];
  node.face = term.face;
  node.directions = directions_of(term.direction);
  node.depth = term.depth;
  if (term.op == ProgramOp::access) node.memo = result_.access_memos++;
  return node;
}

}  // namespace roomgen::lab::annealing
