#include "evaluate/formation_clause.h"

#include <cmath>
#include <random>

#include "catch.h"

using namespace roomgen;

namespace {

std::string fault(const std::vector<Object>& things, int rows) {
  std::vector<const Object*> all;
  for (const auto& thing : things) all.push_back(&thing);
  return rows_fault(all, rows);
}

// Turned by any angle, set anywhere.
std::vector<Object> grid(int rows, int columns, double yaw, const Vec2& corner, double step = 0.9) {
  std::vector<Object> things;
  const Vec2 along(std::cos(yaw), std::sin(yaw)), across(-along.y(), along.x());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Object thing;
      thing.yaw = yaw;
      const Vec2 center = corner + column * step * along + row * 1.4 * across;
      thing.position = {center.x(), center.y(), 0.0};
      things.push_back(thing);
    }
  return things;
}

}  // namespace

TEST_CASE("Rows are found whatever their angle, and only as many as there are") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), place(-5.0, 5.0);
  for (int i = 0; i < 200; ++i) {
    const int rows = 1 + i % 4, columns = 2 + i % 5;
    auto things = grid(rows, columns, angle(random), {place(random), place(random)});
    std::shuffle(things.begin(), things.end(), random);
    CHECK(fault(things, rows).empty());
    // Seen across, as many rows as there were columns.
    if (rows > 1) CHECK(fault(things, columns).empty());
    CHECK_FALSE(fault(things, std::max(rows, columns) + 1).empty());
  }
}

TEST_CASE("One that steps out of line breaks the row, as does a wide gap") {
  auto things = grid(1, 5, 0.3, {1.0, 1.0});
  things[2].position.x() += 0.4 * -std::sin(0.3);
  things[2].position.y() += 0.4 * std::cos(0.3);
  CHECK(fault(things, 1) == "they do not stand in a row");
  CHECK_FALSE(fault(grid(1, 3, 0.0, {0.0, 0.0}, 3.0), 1).empty());
  CHECK_FALSE(fault(grid(1, 1, 0.0, {0.0, 0.0}), 1).empty());
}
