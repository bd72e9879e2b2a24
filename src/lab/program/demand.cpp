#include "demand.h"

#include <algorithm>
#include <limits>
#include <map>

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;
using Places = std::map<SetIds::Key, std::size_t>;

constexpr std::size_t most_wider = 50;  // that are looked at: sets chosen from sets chosen from sets

bool mentions(const ProgramSet& set, const std::string& variable) {
  const auto says = [&](const ProgramSet& part) { return mentions(part, variable); };
  if (set.source == Source::variable) return set.name == variable;
  return std::any_of(set.from.begin(), set.from.end(), says) ||
         std::any_of(set.relations.begin(), set.relations.end(), [&](const SetRelation& relation) {
           return std::any_of(relation.target.begin(), relation.target.end(), says);
         });
}

void tighten(Demand& demand, const CountBound& bound) {
  if (!demand.low_set || bound.low > demand.low) {
    demand.low = bound.low;
    demand.low_set = bound.set;
  }
  if (!demand.high_set || bound.high < demand.high) {
    demand.high = bound.high;
    demand.high_set = bound.set;
  }
}

SetKinds::Mask kinds_of(const Demand& demand, SetKinds& kinds) {
  for (const auto& [name, members] : demand.variables) kinds.bind(name, *members);
  auto mask = kinds.of(*demand.set);
  for (std::size_t i = 0; i < demand.variables.size(); ++i) kinds.unbind();
  return mask;
}

// Each member of a variable's set wants its own, if the set depends on it.
double required(const Demand& demand, const Places& places, const std::vector<Demand>& demands, SetIds& ids) {
  double number = demand.low;
  for (const auto& [name, members] : demand.variables) {
    const auto found = places.find(ids.key(*members, {}));
    const double least = found == places.end() ? 0.0 : demands[found->second].low;
    number *= mentions(*demand.set, name) ? least : std::min(1.0, least);
  }
  return number;
}

// Sets that hold all of its members: what its name stands for, what it chooses from, and so on.
std::vector<const ProgramSet*> wider_sets(const ProgramSet& narrow, const SetKinds& kinds) {
  std::vector<const ProgramSet*> wider;
  const ProgramSet* set = &narrow;
  while (wider.size() < most_wider) {
    if (set->source == Source::named) set = kinds.named(set->name);
    else if (set->source == Source::described && set->from.size() == 1) set = &set->from[0];
    else break;
    if (!set) break;
    wider.push_back(set);
  }
  return wider;
}

// The bounds of a set hold wherever no variable, or none but the demand's own, decides who its members are.
void find_contradiction(Demand& demand, const std::vector<Demand>& demands, const Places& places,
                        const SetKinds& kinds, SetIds& ids) {
  if (demand.low < 1.0) return;
  for (const ProgramSet* set : wider_sets(*demand.set, kinds))
    for (const auto& key : {ids.key(*set, demand.variables), ids.key(*set, {})}) {
      const auto found = places.find(key);
      if (found != places.end() && demands[found->second].high < demand.low) demand.contradicted_by = found->second;
    }
}

double footprint_of(const Kind& kind) {
  const bool only_floor = kind.mount == Mount::floor && kind.also.empty();
  if (!only_floor || kind.traits.flat || !kind.tucks_under.empty()) return 0.0;
  return kind.size.x() * kind.size.y();
}

}  // namespace

std::vector<Demand> demands_of(const ConstraintProgram& program, SetKinds& kinds) {
  std::vector<Demand> demands;
  Places places;
  SetIds ids;
  const auto bounds = count_bounds(program);
  for (const auto& bound : bounds) {
    const auto [entry, is_new] = places.try_emplace(ids.key(*bound.set, bound.variables), demands.size());
    if (is_new) {
      demands.push_back({.set = bound.set, .variables = bound.variables});
      demands.back().kinds = kinds_of(demands.back(), kinds);
    }
    tighten(demands[entry->second], bound);
  }
  for (auto& demand : demands) demand.required = required(demand, places, demands, ids);
  for (auto& demand : demands) find_contradiction(demand, demands, places, kinds, ids);
  return demands;
}

std::optional<double> greatest_floor(const ProgramRoom& room) {
  if (room.polygon) return area(*room.polygon);
  if (room.width && room.depth) return room.width->high * room.depth->high;
  if (room.area) return room.area->high;
  return std::nullopt;
}

double least_footprint(const SetKinds::Mask& mask, const SetKinds& kinds) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kinds.kinds().size(); ++i)
    if (mask[i]) least = std::min(least, footprint_of(*kinds.kinds()[i]));
  return std::isinf(least) ? 0.0 : least;
}

}  // namespace roomgen::lab
