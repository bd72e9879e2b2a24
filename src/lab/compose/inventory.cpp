#include "inventory.h"

#include <algorithm>
#include <map>

#include "brief/room_kinds.h"
#include "kinds/mounting.h"

namespace roomgen::lab::compose {

namespace {

const Requirement* count_clause(const Plan& plan, const std::vector<std::string>& ids) {
  for (const auto& requirement : plan.requirements)
    if (requirement.kind == Requirement::Kind::count &&
        std::ranges::any_of(ids, [&](const auto& id) { return std::ranges::count(requirement.subjects, id) > 0; }))
      return &requirement;
  return nullptr;
}

// How many there may be. A clause that several items share leaves each the number that it is planned with.
Range count_of(const PlanItem& item, const Requirement* clause, const std::vector<std::string>& ids) {
  const double planned = item.quantity;
  if (!clause) return {planned, planned};
  if (clause->most > clause->count && clause->subjects.size() == ids.size())
    return {static_cast<double>(clause->count), static_cast<double>(clause->most)};
  if (clause->at_most) return {0.0, planned};
  return {planned, planned};
}

// What people and what they do need is no number that somebody gave.
bool is_counted(const PlanItem& item, const Requirement* clause) {
  using Source = Requirement::Source;
  return item.asked && (!clause || (clause->source != Source::person && clause->source != Source::activity));
}

// One of the things that the core of the room's kind consists of; what comes with them is none.
bool is_essential(const PlanItem& item, const std::string& room, const KindTable& kinds) {
  const auto& core = brief::built_in_room_kinds()->get(room).core;
  return !item.asked && item.mount == Mount::floor &&
         std::ranges::any_of(core, [&](const brief::Piece& piece) {
           return piece.chance >= 1.0 && std::ranges::any_of(piece.any, [&](const auto& option) {
                    return kinds.is_a(item.category, option.first);
                  });
         });
}

/// Ids of a plan's objects, to the set that they are members of.
using SetsOfIds = std::map<std::string, std::string, std::less<>>;

// Ids of things become the sets that they are in; what carries a thing may be said by its kind.
std::string set_named(const std::string& said, const SetsOfIds& sets, const std::vector<Stand>& stands) {
  if (const auto found = sets.find(said); found != sets.end()) return found->second;
  const auto same = std::ranges::find(stands, said, &Stand::kind);
  return same == stands.end() ? "" : same->name;
}

// Programs put things up only as their kind may be.
Mount possible_mount(const Kind& kind, Mount planned) {
  return may_be_put_up(kind, planned) ? planned : kind.mount;
}

Stand stand_of(const Plan& plan, const PlanItem& item, const std::vector<std::string>& ids, const SetsOfIds& sets,
               const std::vector<Stand>& stands, const KindTable& kinds) {
  Stand stand;
  stand.kind = kinds.get(item.category).lineage.empty() ? item.category : kinds.get(item.category).name;
  stand.mount = possible_mount(kinds.get(item.category), item.mount);
  stand.on = set_named(item.on, sets, stands);
  const Requirement* clause = count_clause(plan, ids);
  stand.asked = is_counted(item, clause);
  stand.count = stand.asked ? count_of(item, clause, ids) : Range{0.0, static_cast<double>(item.quantity)};
  stand.may_grow = stand.asked && clause && clause->at_least;
  stand.essential = is_essential(item, plan.room.type, kinds);
  stand.size = item.size.value_or(kinds.get(item.category).size);
  stand.description = item.description;
  // What has a place stands in a formation: its relations are the plan's own.
  if (item.location) stand.in_rows = !item.facing, stand.at_wall = false;
  if (item.asked && !item.location)
    for (auto relation : item.relations) {
      if (const auto set = set_named(relation.target, sets, stands); !set.empty()) relation.target = set;
      stand.wishes.push_back(std::move(relation));
    }
  return stand;
}

bool joins(const Stand& a, const Stand& b) {
  return a.kind == b.kind && a.mount == b.mount && a.on == b.on && a.wishes == b.wishes && a.asked == b.asked &&
         a.may_grow == b.may_grow && a.in_rows == b.in_rows && a.essential == b.essential;
}

}  // namespace

std::string free_name(const std::vector<Stand>& stands, const std::string& kind) {
  std::string name = kind;
  for (int n = 2; std::ranges::find(stands, name, &Stand::name) != stands.end(); ++n)
    name = kind + " " + std::to_string(n);
  return name;
}

std::vector<Stand> inventory_of(const Plan& plan, const KindTable& kinds) {
  std::map<std::size_t, std::vector<std::string>> ids;
  for (const auto& planned : planned_objects(plan)) ids[planned.item].push_back(planned.id);
  std::vector<Stand> stands;
  SetsOfIds sets;
  for (std::size_t i = 0; i < plan.items.size(); ++i) {
    Stand stand = stand_of(plan, plan.items[i], ids[i], sets, stands, kinds);
    const auto same = std::ranges::find_if(stands, [&](const Stand& other) { return joins(other, stand); });
    if (same != stands.end()) {
      same->count.low += stand.count.low, same->count.high += stand.count.high;
      stand.name = same->name;
    } else {
      stand.name = free_name(stands, stand.kind);
      stands.push_back(stand);
    }
    for (const auto& id : ids[i]) sets[id] = stand.name;
  }
  return stands;
}

double footprint_of(const Stand& stand, const KindTable& kinds) {
  const bool covers = stand.mount == Mount::floor && !kinds.get(stand.kind).traits.flat;
  return covers ? stand.size.x() * stand.size.y() : 0.0;
}

double least_footprint(const std::vector<Stand>& stands, const KindTable& kinds) {
  double sum = 0.0;
  for (const auto& stand : stands) sum += stand.count.low * footprint_of(stand, kinds);
  return sum;
}

double most_footprint(const std::vector<Stand>& stands, const KindTable& kinds) {
  double sum = 0.0;
  for (const auto& stand : stands)
    sum += stand.count.high * footprint_of(stand, kinds);
  return sum;
}

}  // namespace roomgen::lab::compose
