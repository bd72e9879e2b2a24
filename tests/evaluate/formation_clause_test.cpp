#include <cmath>
#include <random>

#include "catch.h"
#include "evaluate/clauses.h"

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

namespace {

// Equal steps around a point, from `first` on, seen in any order.
std::vector<Object> ring(int count, double radius, double first, double step, const Vec2& center) {
  std::vector<Object> things;
  for (int n = 0; n < count; ++n) {
    const double angle = first + step * n;
    Object thing;
    thing.position = {center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle), 0.0};
    things.push_back(thing);
  }
  return things;
}

std::vector<const Object*> pointers(const std::vector<Object>& things) {
  std::vector<const Object*> all;
  for (const auto& thing : things) all.push_back(&thing);
  return all;
}

}  // namespace

TEST_CASE("Circles and arcs are found wherever they stand, and told from each other") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), place(-5.0, 5.0), radius(0.8, 3.0);
  for (int i = 0; i < 200; ++i) {
    const int count = 5 + i % 8;
    const Vec2 center(place(random), place(random));
    auto circle = ring(count, radius(random), angle(random), 2.0 * pi / count, center);
    auto arc = ring(count, radius(random), angle(random), pi / (count - 1), center);
    std::shuffle(circle.begin(), circle.end(), random);
    std::shuffle(arc.begin(), arc.end(), random);
    CHECK(circle_fault(pointers(circle)).empty());
    CHECK(arc_fault(pointers(arc)).empty());
    CHECK_FALSE(circle_fault(pointers(arc)).empty());
    // One that steps inwards is in neither.
    circle.front().position.head<2>() = center;
    CHECK_FALSE(circle_fault(pointers(circle)).empty());
  }
  CHECK_FALSE(circle_fault(pointers(grid(1, 5, 0.4, {0.0, 0.0}))).empty());
  CHECK_FALSE(arc_fault(pointers(grid(1, 5, 0.4, {0.0, 0.0}))).empty());
  CHECK_FALSE(circle_fault(pointers(ring(2, 1.0, 0.0, 3.1, {0.0, 0.0}))).empty());
}
