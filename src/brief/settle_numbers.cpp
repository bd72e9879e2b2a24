#include <algorithm>

#include "settle.h"

namespace roomgen::brief {

namespace {

constexpr int usual_few = 2;
constexpr int seats_at_a_table = 4, seats_at_a_small_table = 2, seats_at_a_desk = 1;
constexpr double small_table = 0.8;    ///< metres: the longer side of a table for two
constexpr double lowest_table = 0.6;   ///< metres: what is lower has no chairs around it
constexpr double usual_row = 3.6;      ///< metres
constexpr int fewest_in_row = 3, most_in_row = 6;
constexpr int fewest_around = 3, usual_around = 6;  ///< in a circle or an arc
constexpr int most_for_all = 40;       ///< of seats and the like that are only counted by what they serve

bool is_seat(const Mention& mention, const KindTable& table) {
  return mention.category == "seat" || table.is_any_of(mention.category, {"chair", "stool"});
}

int seats_at(const Mention& mention, const KindTable& table) {
  const bool is_table = table.is_any_of(mention.category, {"table", "kitchen island"});
  if (!is_table || mention.mount != Mount::floor || mention.size.z() < lowest_table) return 0;
  if (table.is_a(mention.category, "desk")) return seats_at_a_desk;
  return mention.size.head<2>().maxCoeff() < small_table ? seats_at_a_small_table : seats_at_a_table;
}

// For the tables that it is told to be around, else for those that are named with it.
int seats_for_tables(const Mention& seat, const Brief& brief, const KindTable& table) {
  int told = 0, named = 0;
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    const Mention& other = brief.mentions[i];
    const int seats = seats_at(other, table) * std::max(1, other.quantity);
    named += seats;
    const bool is_told = std::any_of(seat.demands.begin(), seat.demands.end(), [&](const Demand& demand) {
      return demand.mention == i && demand.kind == RelationKind::around;
    });
    if (is_told) told += seats;
  }
  return told > 0 ? told : named;
}

// What each of the people has: a desk, a bed of their own.
bool is_personal(const Mention& mention, const KindTable& table) {
  return table.is_any_of(mention.category, {"desk", "bed", "locker", "easel", "computer", "laptop", "monitor"});
}

// Of what people have of their own, as many as of the other things that they have so: computers of four desks.
int number_of_places(const Brief& brief, const KindTable& table) {
  int number = brief.people;
  for (const auto& mention : brief.mentions)
    if (is_personal(mention, table)) number = std::max(number, mention.quantity);
  return number;
}

// "three rows of benches": as many in each as seat the people, or as a row of usual length has.
int number_in_rows(const Mention& mention, const Brief& brief, const KindTable& table) {
  const int rows = std::max(1, mention.formation->rows);
  const bool is_for_people = is_seat(mention, table) || is_personal(mention, table);
  if (is_for_people && brief.people > rows) return (brief.people + rows - 1) / rows * rows;
  const double width = std::max(0.1, table.get(mention.category).size.x());
  return rows * std::clamp(static_cast<int>(usual_row / width), fewest_in_row, most_in_row);
}

// "chairs in a circle"
int number_around(const Mention& mention, const Brief& brief, const KindTable& table) {
  const bool is_for_people = is_seat(mention, table) || is_personal(mention, table);
  return is_for_people && brief.people >= fewest_around ? brief.people : usual_around;
}

int number_of(const Mention& mention, const Brief& brief, const KindTable& table) {
  if (mention.formation && mention.formation->is_round()) return number_around(mention, brief, table);
  if (mention.formation && mention.formation->columns == 0) return number_in_rows(mention, brief, table);
  // How many windows there will be is not known yet.
  if (table.get(mention.category).covers_window) return 1;
  if (is_seat(mention, table)) {
    if (brief.people > 0) return brief.people;
    const int seats = seats_for_tables(mention, brief, table);
    return seats > 0 ? seats : std::max(usual_few, mention.joined_to);
  }
  if (mention.joined_to > 1) return mention.joined_to;
  return is_personal(mention, table) ? std::max(usual_few, number_of_places(brief, table)) : usual_few;
}

// "beds, a lamp over each bed": as many as the beds turn out to be.
void settle_shared(Brief& brief) {
  for (const auto& shared : brief.shared_out) {
    if (!shared.place.empty()) continue;
    const Mention& owner = brief.mentions[shared.owner];
    Mention& thing = brief.mentions[shared.thing];
    const int number = shared.count * owner.quantity;
    const bool is_short = thing.open ? thing.quantity < number : owner.open && thing.quantity == shared.count;
    if (is_short && number <= most_for_all) thing.quantity = number;
  }
}

}  // namespace

void settle_numbers(Brief& brief, const KindTable& table) {
  // Seats are counted by the tables, whose number is settled first.
  for (const bool seats : {false, true})
    for (auto& mention : brief.mentions)
      if (mention.quantity == 0 && is_seat(mention, table) == seats) {
        mention.open = true;
        mention.quantity = std::min(most_for_all, number_of(mention, brief, table));
      }
  settle_shared(brief);
}

void settle_numbers_on_carriers(Brief& brief) {
  for (auto& mention : brief.mentions) {
    const auto support = support_of(mention);
    if (!mention.open || !support || mention.mount != Mount::surface) continue;
    const int carriers = brief.mentions[*support].quantity;
    mention.quantity = std::clamp(carriers, mention.quantity, most_for_all);
  }
}

}  // namespace roomgen::brief
