#include "evaluator.h"

#include <algorithm>
#include <cmath>

#include "nothing.h"

namespace roomgen::lab::annealing {

namespace {

double or_zero(double value) { return is_nothing(value) ? 0.0 : value; }

}  // namespace

Evaluator::Evaluator(const Compiled& program, const World& world)
    : program_(program),
      world_(world),
      area_(area(world.room().polygon)),
      accesses_(static_cast<std::size_t>(program.access_memos)),
      sets_(program.sets.size()),
      counts_(static_cast<std::size_t>(program.structure_memos)) {}

Worth Evaluator::worth() {
  const int things = world_.things().size();
  distances_.fit(things);
  shared_.fit(things);
  to_room_.fit(things);
  for (auto& memo : accesses_) memo.fit(things);
  Worth worth;
  for (const auto& constraint : program_.constraints) worth.violation += violation(constraint.term);
  for (const auto& score : program_.scores) worth.loss += or_zero(value(score.term));
  for (const auto& tie : program_.ties) {
    const auto how = held(tie);
    worth.violation += how ? how->lost : tie.missing;
    worth.loss -= how ? how->degree : 0.0;
  }
  return worth;
}

// Sets.

SlotSet Evaluator::members(int set) {
  const SetNode& node = program_.sets[static_cast<std::size_t>(set)];
  if (!node.is_closed) return find_members(node);
  return of_structure(sets_, set, [&] { return find_members(node); });
}

SlotSet Evaluator::members(int set, const std::vector<Slot>& variables) {
  std::ranges::copy(variables, variables_.begin());
  return members(set);
}

double Evaluator::violation(const TermNode& truth, const std::vector<Slot>& variables) {
  std::ranges::copy(variables, variables_.begin());
  return violation(truth);
}

bool Evaluator::is_related(Slot slot, const SetNode::Relation& relation, const SlotSet& targets) const {
  return std::ranges::any_of(world_.item(slot).stance.held(), [&](const Attachment& attachment) {
    return relation.kinds[static_cast<std::size_t>(attachment.relation)] && targets.has(attachment.target);
  });
}

SlotSet Evaluator::find_members(const SetNode& node) {
  using Source = ProgramSet::Source;
  SlotSet set;
  switch (node.source) {
    case Source::objects: set = world_.things(); break;
    case Source::room: set.insert(room_slot); break;
    case Source::doors: set = world_.doors(); break;
    case Source::windows: set = world_.windows(); break;
    case Source::variable: set.insert(variables_[static_cast<std::size_t>(node.variable)]); break;
    case Source::united:
      for (const int from : node.from) set |= members(from);
      break;
    default: set = node.from.empty() ? world_.things() : members(node.from.front()); break;
  }
  if (node.filter >= 0) {
    const auto& passes = program_.filters[static_cast<std::size_t>(node.filter)].passes;
    const SlotSet all = set;
    all.each([&](Slot slot) {
      if (slot >= most_things || !passes[static_cast<std::size_t>(world_.item(slot).kind_number)]) set.erase(slot);
    });
  }
  for (const auto& relation : node.relations) {
    const SlotSet targets = members(relation.target), all = set;
    all.each([&](Slot slot) {
      if (slot >= most_things || is_related(slot, relation, targets) == relation.absent) set.erase(slot);
    });
  }
  return set;
}

// Numbers.

double Evaluator::over_members(const TermNode& node) {
  const SlotSet set = members(node.sets[0]);
  double sum = 0.0;
  int counted = 0;
  set.each([&](Slot slot) {
    variables_[static_cast<std::size_t>(node.variable)] = slot;
    const double value = this->value(node.operands[0]);
    if (is_nothing(value)) return;
    sum += value;
    ++counted;
  });
  if (node.op == ProgramOp::sum) return sum;
  return counted == 0 ? nothing : sum / counted;
}

double Evaluator::arithmetic(const TermNode& node) {
  const auto operand = [&](std::size_t i) { return value(node.operands[i]); };
  switch (node.op) {
    case ProgramOp::add: {
      // Scores are sums of parts of which some may have nothing to say.
      double sum = 0.0;
      for (const auto& part : node.operands) sum += or_zero(value(part));
      return sum;
    }
    case ProgramOp::multiply: {
      double product = 1.0;
      for (const auto& part : node.operands) product *= value(part);
      return product;
    }
    case ProgramOp::subtract: return node.operands.size() == 1 ? -operand(0) : operand(0) - operand(1);
    case ProgramOp::divide: {
      const double above = operand(0), below = operand(1);
      return below == 0.0 ? (above == 0.0 ? 0.0 : 1.0) : above / below;
    }
    case ProgramOp::power: return std::pow(operand(0), operand(1));
    case ProgramOp::absolute: return std::abs(operand(0));
    case ProgramOp::logarithm: return std::log(std::max(1e-12, operand(0)));
    case ProgramOp::least: case ProgramOp::greatest: {
      double best = nothing;
      for (const auto& part : node.operands) {
        const double one = value(part);
        if (is_nothing(one)) continue;
        if (is_nothing(best) || (node.op == ProgramOp::least ? one < best : one > best)) best = one;
      }
      return best;
    }
    case ProgramOp::clamp: {
      const double inner = operand(0);
      return is_nothing(inner) ? nothing : std::clamp(inner, node.low, node.high);
    }
    case ProgramOp::hinge: {
      const double inner = operand(0);
      return is_nothing(inner) ? nothing : std::max({0.0, node.low - inner, inner - node.high});
    }
    case ProgramOp::minimize: return node.number * or_zero(operand(0));
    case ProgramOp::maximize: return -node.number * or_zero(operand(0));
    default: return nothing;
  }
}

double Evaluator::value(const TermNode& node) {
  if (node.structure_memo < 0) return find_value(node);
  return of_structure(counts_, node.structure_memo, [&] { return find_value(node); });
}

double Evaluator::find_value(const TermNode& node) {
  switch (node.op) {
    case ProgramOp::constant: return node.number;
    case ProgramOp::count: return members(node.sets[0]).size();
    case ProgramOp::footprint: return floor_area(members(node.sets[0]), false);
    case ProgramOp::area: {
      const SlotSet set = members(node.sets[0]);
      return set.has(room_slot) ? area_ : floor_area(set, false);
    }
    case ProgramOp::volume: {
      double sum = 0.0;
      members(node.sets[0]).each([&](Slot slot) {
        sum += slot == room_slot ? area_ * world_.room().height : world_.item(slot).object.size.prod();
      });
      return sum;
    }
    case ProgramOp::occupancy: return floor_area(members(node.sets[0]), true) / area_;
    case ProgramOp::distance: return distance(node);
    case ProgramOp::gap: return gap(node);
    case ProgramOp::seats: return seats(node);
    case ProgramOp::access: return access(node);
    case ProgramOp::angle: return angle(node);
    case ProgramOp::focus: return focus(node);
    case ProgramOp::center: return center(node);
    case ProgramOp::reflection: {
      const auto about = footprints(node.sets[1]);
      return about.empty() ? nothing : reflection_asymmetry(footprints(node.sets[0]), about.front());
    }
    case ProgramOp::rotation: return rotation_asymmetry(footprints(node.sets[0]));
    case ProgramOp::coplanarity: return uncoplanarity(footprints(node.sets[0]));
    case ProgramOp::mean:
    case ProgramOp::sum: return over_members(node);
    default: return arithmetic(node);
  }
}

// Truths.

double Evaluator::comparison(const TermNode& node) {
  const double left = value(node.operands[0]);
  if (is_nothing(left)) return 0.0;
  if (node.op == ProgramOp::within) return std::max({0.0, node.low - left, left - node.high});
  const double right = value(node.operands[1]);
  if (is_nothing(right)) return 0.0;
  constexpr double strict = 1e-9;  // what `<` misses when both are equal
  switch (node.op) {
    case ProgramOp::equal: return std::abs(left - right);
    case ProgramOp::unequal: return left == right ? 1.0 : 0.0;
    case ProgramOp::at_least: return std::max(0.0, right - left);
    case ProgramOp::at_most: return std::max(0.0, left - right);
    case ProgramOp::more: return left > right ? 0.0 : right - left + strict;
    default: return left < right ? 0.0 : left - right + strict;
  }
}

double Evaluator::violation(const TermNode& node) {
  if (node.structure_memo < 0) return find_violation(node);
  return of_structure(counts_, node.structure_memo, [&] { return find_violation(node); });
}

double Evaluator::find_violation(const TermNode& node) {
  switch (node.op) {
    case ProgramOp::all_of: {
      double sum = 0.0;
      for (const auto& part : node.operands) sum += violation(part);
      return sum;
    }
    case ProgramOp::any_of: {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& part : node.operands) least = std::min(least, violation(part));
      return least;
    }
    case ProgramOp::not_of: return violation(node.operands[0]) > 0.0 ? 0.0 : 1.0;
    case ProgramOp::for_all: {
      double sum = 0.0;
      members(node.sets[0]).each([&](Slot slot) {
        variables_[static_cast<std::size_t>(node.variable)] = slot;
        sum += violation(node.operands[0]);
      });
      return sum;
    }
    default: return comparison(node);
  }
}

}  // namespace roomgen::lab::annealing
