#include <algorithm>
#include <cmath>
#include <map>

#include "check_rules.h"
#include "limits.h"
#include "roomgen/base/text.h"
#include "set_ids.h"

namespace roomgen::lab {

namespace {

using program_limits::members;

constexpr double planned_openings = 16.0;  // of a room that is yet to be made: more than any gets
constexpr int chained =
    3;  // things that bring others that bring others: beyond that as many as a room holds

// What the constraints let come into a room for one set, by all their bounds of it.
struct Supply {
  CountBound bound;
  SetKinds::Mask kinds;
  double total = 0.0;
};

bool is_closed(const ProgramSet& set) {
  const auto is_target_closed = [](const SetRelation& one) {
    return std::ranges::all_of(one.target, is_closed);
  };
  return set.source != ProgramSet::Source::variable && std::ranges::all_of(set.from, is_closed) &&
         std::ranges::all_of(set.relations, is_target_closed);
}

bool binds(const ProgramTerm& term) {
  return term.op == ProgramOp::for_all || term.op == ProgramOp::mean || term.op == ProgramOp::sum;
}

bool meet(const SetKinds::Mask& a, const SetKinds::Mask& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] && b[i]) return true;
  return false;
}

class Work {
 public:
  Work(const ConstraintProgram& program, SetKinds& kinds)
      : kinds_(kinds),
        openings_(program.room.openings ? static_cast<double>(program.room.openings->size())
                                        : planned_openings) {
    find_supplies(program);
  }

  /// Steps of one look at a term.
  double of(const ProgramTerm& term) {
    double work = 1.0 + measuring(term);
    for (const auto& set : term.sets) work += looking_up(set);
    if (!binds(term)) {
      for (const auto& operand : term.operands) work += of(operand);
      return work;
    }
    const double times = size(term.sets[0]);
    kinds_.bind(term.name, term.sets[0]);
    work += times * of(term.operands[0]);
    kinds_.unbind();
    return work;
  }

 private:
  void find_supplies(const ConstraintProgram& program) {
    SetIds ids;
    std::map<SetIds::Key, std::size_t> places;
    for (const auto& bound : count_bounds(program)) {
      const auto [place, is_new] =
          places.try_emplace(ids.key(*bound.set, bound.variables), supplies_.size());
      if (is_new) supplies_.push_back({bound, kinds_of(bound), 0.0});
      double& high = supplies_[place->second].bound.high;
      const double most =
          std::isinf(bound.high) ? bound.low + program_limits::permitted : bound.high;
      high = is_new ? most : std::max(high, most);
    }
    for (int round = 0; round <= chained; ++round)
      for (auto& supply : supplies_) {
        const double total = total_of(supply);
        if (total > supply.total) supply.total = round == chained ? members : total;
      }
  }

  SetKinds::Mask kinds_of(const CountBound& bound) {
    for (const auto& [name, set] : bound.variables) kinds_.bind(name, *set);
    auto mask = kinds_.of(*bound.set);
    for (std::size_t i = 0; i < bound.variables.size(); ++i) kinds_.unbind();
    return mask;
  }

  // Each member of what its variables run over brings its own.
  double total_of(const Supply& supply) {
    double total = supply.bound.high;
    for (const auto& [name, set] : supply.bound.variables) {
      total *= size(*set);
      kinds_.bind(name, *set);
    }
    for (std::size_t i = 0; i < supply.bound.variables.size(); ++i) kinds_.unbind();
    return std::min(total, members);
  }

  // How many members a set may have: what is in no bound's set never comes into the room.
  double size(const ProgramSet& set) {
    if (set.source == ProgramSet::Source::variable || kinds_.is_room(set)) return 1.0;
    const auto mask = kinds_.of(set);
    double sum = mask.back() ? openings_ : 0.0;
    for (const auto& supply : supplies_) {
      if (sum >= members) break;
      if (meet(mask, supply.kinds)) sum += supply.total;
    }
    return std::min(sum, members);
  }

  // Sets without variables are remembered from one look to the next.
  double looking_up(const ProgramSet& set) {
    if (set.source != ProgramSet::Source::described && set.source != ProgramSet::Source::united)
      return 1.0;
    if (is_closed(set)) return 1.0;
    double work = 1.0;
    for (const auto& part : set.from) work += looking_up(part);
    for (const auto& relation : set.relations)
      for (const auto& target : relation.target) work += looking_up(target);
    const double chosen_from = set.from.empty() ? size({}) : size(set.from[0]);
    return work + chosen_from * static_cast<double>(set.relations.size());
  }

  // What is asked of two sets is asked of pairs, and so is most that is asked of one.
  double measuring(const ProgramTerm& term) {
    if (binds(term) || term.sets.empty() || term.op == ProgramOp::count) return 0.0;
    const double first = size(term.sets[0]);
    if (term.op == ProgramOp::reflection) return first * first * first;  // who is whose image
    return first * (term.sets.size() > 1 ? size(term.sets[1]) : first);
  }

  SetKinds& kinds_;
  double openings_ = 0.0;
  std::vector<Supply> supplies_;
};

// The part of a term that makes it dear: what all of it is multiplied by.
const ProgramTerm& costliest(const ProgramTerm& term, Work& work) {
  if (binds(term)) return term;
  const double half = 0.5 * work.of(term);
  for (const auto& operand : term.operands)
    if (work.of(operand) > half) return costliest(operand, work);
  return term;
}

}  // namespace

void check_work(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings) {
  Work work(program, kinds);
  double total = 0.0, most = 0.0;
  const NamedTerms::value_type* dearest = nullptr;
  for (const auto* terms : {&program.constraints, &program.scores})
    for (const auto& named : *terms) {
      const double own = work.of(named.second);
      total += own;
      if (own > most) most = own, dearest = &named;
    }
  if (total <= program_limits::work) return;
  const ProgramTerm& part = costliest(dearest->second, work);
  findings.error(part.at.empty() ? dearest->first : part.at,
                 "one look at a full room takes up to " + format_number(total) +
                     " steps, most of them here; a program "
                     "may take " +
                     format_number(program_limits::work) +
                     ": what all, mean and sum run over multiplies, so "
                     "nest fewer of them or bound the counts of what they run over");
}

}  // namespace roomgen::lab
