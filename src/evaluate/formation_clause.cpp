#include "formation_clause.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace roomgen {

namespace {

constexpr double straight = 0.15, together = 2.5;  // metres

/// A thing's place along its row, and across the rows.
struct Spot {
  double along = 0.0, across = 0.0;
};
using Row = std::vector<Spot>;

std::vector<Row> rows_along(std::span<const Object* const> things, double angle) {
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  std::vector<Spot> spots;
  for (const Object* thing : things) {
    const Vec2 center = thing->position.head<2>();
    spots.push_back({center.dot(along), center.dot(across)});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.across < b.across; });
  std::vector<Row> rows;
  for (const Spot& spot : spots) {
    if (rows.empty() || spot.across - rows.back().front().across > straight) rows.emplace_back();
    rows.back().push_back(spot);
  }
  return rows;
}

bool hangs_together(Row row) {
  std::sort(row.begin(), row.end(), [](const Spot& a, const Spot& b) { return a.along < b.along; });
  return std::adjacent_find(row.begin(), row.end(), [](const Spot& a, const Spot& b) {
           return b.along - a.along > together;
         }) == row.end();
}

// As many in each, or fewer in one.
bool are_even(const std::vector<Row>& rows) {
  const auto size = std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
                      return a.size() < b.size();
                    })->size();
  return size > 1 && std::count_if(rows.begin(), rows.end(),
                                   [&](const Row& row) { return row.size() < size; }) <= 1;
}

bool stand_in_rows(std::span<const Object* const> things, int wanted, double angle) {
  const auto rows = rows_along(things, angle);
  const bool as_many = wanted > 0 ? rows.size() == static_cast<std::size_t>(wanted) : rows.size() > 1;
  return as_many && are_even(rows) && std::all_of(rows.begin(), rows.end(), hangs_together);
}

}  // namespace

std::string rows_fault(std::span<const Object* const> things, int rows) {
  if (things.size() < 2) return "a single thing makes no row";
  const double yaw = things.front()->yaw;
  for (const double angle : {yaw, yaw + std::numbers::pi / 2.0})
    if (stand_in_rows(things, rows, angle)) return "";
  return rows == 1 ? "they do not stand in a row"
         : rows > 1 ? "they do not stand in " + std::to_string(rows) + " rows"
                    : "they do not stand in rows";
}

}  // namespace roomgen
