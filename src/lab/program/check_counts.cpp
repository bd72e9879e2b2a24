#include <algorithm>
#include <cmath>

#include "check_rules.h"
#include "demand.h"
#include "limits.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

void check_bounds(const Demand& demand, ProgramFindings& findings) {
  const std::string what = to_text(*demand.set);
  if (demand.low > demand.high)
    findings.error(demand.low_set->at, "at least " + format_number(demand.low) + " and at most " +
                                           format_number(demand.high) + " of \"" + what + "\" contradict each other");
  else if (std::isinf(demand.high))
    findings.warn(demand.low_set->at, "nothing limits how many of \"" + what +
                                          "\" there may be: without an upper bound any number is permitted; say in");
  if (demand.required >= 1.0 && std::find(demand.kinds.begin(), demand.kinds.end(), true) == demand.kinds.end())
    findings.error(demand.low_set->at, "at least " + format_number(demand.low) + " of \"" + what +
                                           "\" are wanted, and no kind of thing is all of that");
}

void check_wider(const Demand& demand, const std::vector<Demand>& demands, ProgramFindings& findings) {
  if (!demand.contradicted_by || demand.low > demand.high) return;
  const Demand& wider = demands[*demand.contradicted_by];
  findings.error(demand.low_set->at, "at least " + format_number(demand.low) + " of \"" + to_text(*demand.set) +
                                         "\", but at most " + format_number(wider.high) + " of \"" +
                                         to_text(*wider.set) + "\", which they belong to (" + wider.high_set->at + ")");
}

bool are_disjoint(const SetKinds::Mask& a, const SetKinds::Mask& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] && b[i]) return false;
  return true;
}

struct Total {
  double sum = 0.0;
  const Demand* greatest = nullptr;
};

// The sum over demands of different kinds, the greatest first: one thing may answer several demands of one kind.
template <typename Amount>
Total total_of(const std::vector<Demand>& demands, Amount amount) {
  std::vector<std::pair<double, const Demand*>> ordered;
  for (const auto& demand : demands)
    if (const double value = amount(demand); value > 0.0) ordered.emplace_back(value, &demand);
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  Total total;
  SetKinds::Mask taken;
  for (const auto& [value, demand] : ordered) {
    if (taken.empty()) taken.assign(demand->kinds.size(), false);
    if (!are_disjoint(taken, demand->kinds)) continue;
    for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = taken[i] || demand->kinds[i];
    total.sum += value;
    if (!total.greatest) total.greatest = demand;
  }
  return total;
}

void check_number(const std::vector<Demand>& demands, ProgramFindings& findings) {
  const Total total = total_of(demands, [](const Demand& demand) { return demand.required; });
  if (total.sum <= static_cast<double>(program_limits::objects)) return;
  findings.error(total.greatest->low_set->at, "the constraints demand " + format_number(total.sum) +
                                                  " things; a room holds at most " +
                                                  std::to_string(program_limits::objects));
}

void check_floor(const ProgramRoom& room, const std::vector<Demand>& demands, const SetKinds& kinds,
                 ProgramFindings& findings) {
  const auto floor = greatest_floor(room);
  if (!floor) return;
  const Total total = total_of(demands, [&](const Demand& demand) {
    return demand.required > 0.0 ? demand.required * least_footprint(demand.kinds, kinds) : 0.0;
  });
  if (total.sum <= *floor) return;
  // Rooms that hold some of it are better than none.
  findings.warn(total.greatest->low_set->at,
                "the things that are demanded cover at least " + format_number(total.sum, 1) + " m2, and the room has " +
                    format_number(*floor, 1) + " m2 of floor; demand fewer, or a larger room");
}

}  // namespace

void check_counts(const ConstraintProgram& program, SetKinds& kinds, ProgramFindings& findings) {
  const auto demands = demands_of(program, kinds);
  if (demands.empty())
    findings.warn("/constraints", "no constraint counts anything, so the room stays empty");
  for (const auto& demand : demands) {
    if (findings.full()) return;
    check_bounds(demand, findings);
    check_wider(demand, demands, findings);
  }
  check_number(demands, findings);
  check_floor(program.room, demands, kinds, findings);
}

}  // namespace roomgen::lab
