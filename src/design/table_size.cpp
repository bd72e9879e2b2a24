#include "table_size.h"

#include <algorithm>
#include <cmath>

#include "inventory.h"

namespace roomgen::design {

namespace {

constexpr double seat_width = 0.61;
constexpr double end_depth = 0.25;  ///< more length when people sit at the ends as well
constexpr double longest = 4.0;

bool seats_people(const CategoryTable& table, const std::string& category) {
  return table.is_a(category, "dining table") || category == "table";
}

}  // namespace

Vec3 table_for(const Vec3& usual, bool round, int seats) {
  Vec3 size = usual;
  if (round) {
    const double diameter = std::min(2.2, seats * seat_width / pi + 0.25);
    size.x() = std::max(size.x(), diameter);
    size.y() = std::max(size.y(), diameter);
    return size;
  }
  // Up to four sit at the long sides, then two at the ends, then more at the sides.
  const int a_side = seats <= 4 ? (seats + 1) / 2 : (seats - 1) / 2;
  const double length = seat_width * a_side + 0.2 + (seats > 4 ? end_depth : 0.0);
  size.x() = std::min(longest, std::max(size.x(), length));
  return size;
}

void fit_tables(std::vector<Draft>& drafts, const Brief& brief, const CategoryTable& table) {
  int seats = brief.people;
  for (const auto& draft : drafts)
    if (table.is_a(draft.item.category, "chair") &&
        !table.is_a(draft.item.category, "office chair"))
      seats = std::max(seats, draft.item.quantity);
  if (seats == 0) return;
  int tables = 0;
  for (const auto& draft : drafts)
    if (seats_people(table, draft.item.category)) tables += draft.item.quantity;
  for (auto& draft : drafts) {
    if (!seats_people(table, draft.item.category) || !draft.item.size) continue;
    if (brief.mentions.at(draft.mention).sized) continue;
    const int each = std::min(20, (seats + tables - 1) / tables);
    draft.item.size =
        table_for(*draft.item.size, table.get(draft.item.category).traits.round, each);
  }
}

}  // namespace roomgen::design
