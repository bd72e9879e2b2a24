#include <algorithm>
#include <cmath>

#include "brief/said_wish.h"
#include "brief/room_kinds.h"
#include "brief/table_size.h"
#include "compose_steps.h"
#include "inventory.h"
#include "meet.h"
#include "plan/planning.h"
#include "roomgen/lab/compose.h"
#include "roomgen/design/designer.h"
#include "solve/arrangement.h"

namespace roomgen::lab {

namespace {

using namespace compose;

constexpr int most_floors = 3;        // tried until the inventory and its floor agree
constexpr double same_floor = 0.08;   // share of the area
constexpr double greatest_floor = 400.0;
constexpr double most_at_table = 30.0;

/// A request as far as it is understood.
struct ProgramReading {
  PlanRequest request;
  Complexity asked;
  bool is_room_free = true;
};

double area_of(const Room& room) { return area(room.polygon); }

bool is_size_said(const PlanRequest& request) {
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds || request.size || request.room) return true;
  const auto brief = brief::brief_of(request, *kinds, KindTable::built_in());
  return brief.size || brief.area;
}

// A room of that area, of the plan's proportions.
Vec2 scaled(const Room& room, double wanted) {
  const Vec2 box = bounds(room.polygon).size();
  const double factor = std::sqrt(wanted / area_of(room));
  return (box * factor * 100.0).array().round().matrix() / 100.0;
}

// Makes tables large enough for those who are put up against them.
void seat_at_tables(const ConstraintProgram& program, const KindTable& kinds, std::vector<Stand>& stands) {
  for (auto& table : stands) {
    if (!kinds.is_a(table.kind, "table") || kinds.is_a(table.kind, "desk") || table.count.low < 1.0) continue;
    double seats = 0.0;
    for (const auto& [name, members] : program.sets)
      for (const auto& relation : members.relations)
        if (relation.relation == "front_against" && relation.target.front().name == table.name)
          seats += std::ranges::find(stands, name, &Stand::name)->count.high;
    const int each = static_cast<int>(std::ceil(std::min(seats / table.count.low, most_at_table)));
    if (each > 0)
      table.size = brief::table_for(table.size, kinds.get(table.kind).traits.round, each);
  }
}

struct Furnished {
  Plan plan;
  std::vector<Stand> stands;
  std::vector<std::string> notes;
};

const brief::RoomKind& kind_of(const Room& room) {
  return brief::built_in_room_kinds()->get(room.type);
}

// The floor that the inventory wants: as full as is asked for, else no fuller than such rooms are.
std::optional<double> wanted_floor(const Plan& plan, const std::vector<Stand>& stands, const Complexity& asked,
                                   const KindTable& kinds) {
  constexpr double each_seat = 0.6, each_shelf = 0.4;  // m2, of what nobody counts by name
  if (const auto floor = floor_for(asked, stands, kinds)) return std::min(*floor, greatest_floor);
  double covered = least_footprint(stands, kinds);
  if (asked.seats) covered += each_seat * asked.seats->low;
  if (asked.shelves) covered += each_shelf * asked.shelves->low;
  const double least = covered / kind_of(plan.room).share.high;
  if (least > area_of(plan.room)) return std::min(least, greatest_floor);
  return std::nullopt;
}

// In a room of a given size, what is counted becomes as small as it takes.
void shrink_to_fit(const Complexity& asked, double area, const KindTable& kinds, std::vector<Stand>& stands) {
  constexpr double smallest = 0.6;
  if (!asked.occupancy) return;
  const double wanted = middle_share(*asked.occupancy) * area;
  const double factor = std::max(smallest, std::sqrt(wanted / std::max(wanted, least_footprint(stands, kinds))));
  for (auto& stand : stands) stand.size.head<2>() *= factor;
}

// Programs are about known kinds; what is none is left to the ledger, which says that it is not there.
void leave_unknown(const KindTable& kinds, Furnished& furnished) {
  std::erase_if(furnished.stands, [&](const Stand& stand) {
    const Kind* kind = kinds.by_name(stand.kind);
    const bool is_known = kind && !kind->is_stand_in();
    if (!is_known && stand.asked)
      furnished.notes.push_back("\"" + stand.description + "\" is left out: programs are about known kinds of things");
    return !is_known;
  });
}

/// Plans, and plans again until the inventory and its floor agree.
Result<Furnished> furnish(ProgramReading& reading, const KindTable& kinds) {
  const auto designer = make_rule_designer();
  Furnished furnished;
  for (int i = 0;; ++i) {
    auto plan = designer->plan(reading.request);
    if (!plan) return plan.error();
    furnished = {*std::move(plan), {}, {}};
    const Means means{kind_of(furnished.plan.room), furnished.plan.excluded, kinds};
    furnished.stands = inventory_of(furnished.plan, kinds);
    leave_unknown(kinds, furnished);
    meet_numbers(reading.asked, means, furnished.stands, furnished.notes);
    const double area = area_of(furnished.plan.room);
    const auto floor =
        reading.is_room_free ? wanted_floor(furnished.plan, furnished.stands, reading.asked, kinds) : std::nullopt;
    if (!floor || i == most_floors || std::abs(*floor / area - 1.0) < same_floor) break;
    reading.request.size = scaled(furnished.plan.room, *floor);
  }
  const double area = area_of(furnished.plan.room);
  if (!reading.is_room_free) shrink_to_fit(reading.asked, area, kinds, furnished.stands);
  meet_occupancy(reading.asked, {kind_of(furnished.plan.room), furnished.plan.excluded, kinds}, area, furnished.stands);
  return furnished;
}

}  // namespace

Result<WrittenProgram> write_program(const ComposeRequest& request) {
  const KindTable& kinds = KindTable::built_in();
  ProgramReading reading{request.plan, overridden(complexity_of(request.plan.prompt), request.complexity),
                  !is_size_said(request.plan)};
  auto result = furnish(reading, kinds);
  if (!result) return result.error();
  Furnished& furnished = *result;
  WrittenProgram written;
  written.notes = furnished.plan.notes;
  written.notes.insert(written.notes.end(), furnished.notes.begin(), furnished.notes.end());
  written.program =
      program_of(furnished.stands, reading.asked, furnished.plan, kinds, *built_in_arrangements(), written.notes);
  seat_at_tables(written.program, kinds, furnished.stands);
  for (const auto& stand : furnished.stands)
    written.stock.push_back({stand.kind, stand.description, stand.size, stand.mount, stand.asked});
  written.plan = std::move(furnished.plan);
  written.asked = reading.asked;
  written.is_room_free = reading.is_room_free;
  return written;
}

}  // namespace roomgen::lab
