#include <algorithm>

#include "brief/table_size.h"
#include "inventory.h"

namespace roomgen::plan {

namespace {

bool seats_people(const KindTable& table, const std::string& category) {
  return table.is_any_of(category, {"dining table", "conference table"}) || category == "table";
}

}  // namespace

void fit_tables(std::vector<Draft>& drafts, const brief::Brief& brief, const KindTable& table) {
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
        brief::table_for(*draft.item.size, table.get(draft.item.category).traits.round, each);
  }
}

}  // namespace roomgen::plan
