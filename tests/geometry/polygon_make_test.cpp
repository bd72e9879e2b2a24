#include <limits>

#include "catch.h"
#include "roomgen/geometry/polygon.h"
#include "support/contains.h"
#include "support/error_of.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

std::string complaint(std::vector<Vec2> points) {
  return error_of(make_polygon(std::move(points)));
}

}  // namespace

TEST_CASE("Either winding becomes counter-clockwise with the same area") {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    auto points = shapes::random_star(random, {0, 0}, 1, 4, random.integer(3, 12)).points;
    const double size = std::abs(signed_area(points));
    if (random.chance(0.5)) std::reverse(points.begin(), points.end());
    const auto made = make_polygon(points);
    REQUIRE(made);
    REQUIRE(signed_area(made->points) == Approx(size));
  }
}

TEST_CASE("Repeated corners and corners in line are dropped") {
  //  3---2        3--x--2
  //  |   |   of   |     x
  //  0---1        0-x-x-1 (repeated)
  const auto made = make_polygon({{0, 0}, {1, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 3}, {2, 3},
                                  {0, 3}, {0, 0}});
  REQUIRE(made);
  REQUIRE(made->size() == 4);
  CHECK(area(*made) == Approx(12.0));
}

TEST_CASE("The inside is to the left of every edge") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const auto polygon = shapes::random_star(random, {1, 1}, 1, 4, random.integer(3, 10));
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 inside = polygon.edge(k).middle() + 1e-6 * polygon.inward(k);
      REQUIRE(shapes::winds_around(polygon.points, inside));
      REQUIRE(polygon.inward(k).norm() == Approx(1.0));
    }
  }
}

TEST_CASE("The corners of an L are convex but for the one inside") {
  //  5------4
  //  |      |
  //  |  2---3  <- corner 2 is the inner one
  //  |  |
  //  0--1
  const Polygon l{{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {0, 4}}};
  for (std::size_t k = 0; k < l.size(); ++k) CHECK(l.is_convex_corner(k) == (k != 2));
}

TEST_CASE("Too few corners, corners in line and no area are refused") {
  CHECK(contains_text(complaint({}), "at least three corners"));
  CHECK(contains_text(complaint({{0, 0}, {1, 1}}), "at least three corners"));
  CHECK(contains_text(complaint({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), "polygon: "));
  CHECK(contains_text(complaint({{0, 0}, {1, 0}, {1, 1e-5}}), "no area"));
}

TEST_CASE("Coordinates that are no numbers are refused") {
  const double nan = std::nan("");
  CHECK(contains_text(complaint({{0, 0}, {4, nan}, {4, 4}}), "finite"));
  CHECK(contains_text(complaint({{0, 0}, {4, std::numeric_limits<double>::infinity()}, {4, 4}}), "finite"));
}

TEST_CASE("A polygon that crosses itself is refused with the edges that do") {
  //  3   2         the bow tie 0 1 3 2
  //   \ / .
  //   / \ .
  //  0   1
  const auto bow_tie = complaint({{0, 0}, {4, 0}, {0, 4}, {5, 6}});
  CHECK(contains_text(bow_tie, "crosses"));
  CHECK(contains_text(bow_tie, "the edge from ("));
  CHECK(is_one_line(bow_tie));
  // One whose halves cancel out.
  CHECK_FALSE(complaint({{0, 0}, {4, 0}, {0, 4}, {4, 4}}).empty());
}

TEST_CASE("A polygon that touches itself is refused") {
  //  +-----+        a corner that reaches the opposite edge
  //  |  /\ |
  //  +-/--\+
  CHECK_FALSE(complaint({{0, 0}, {1, 0}, {2, 4}, {3, 0}, {4, 0}, {4, 4}, {0, 4}}).empty());
  // Two rooms joined in one point.
  CHECK_FALSE(complaint({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}).empty());
  // A wall that goes out and comes back along itself.
  CHECK_FALSE(complaint({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}}).empty());
}

TEST_CASE("Two corners of a star swapped make it cross itself, and it is refused") {
  Random random(3);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    auto points = shapes::random_star(random, {0, 0}, 2, 3, 8).points;
    std::swap(points[1], points[4]);
    refused += complaint(points).empty() ? 0 : 1;
  }
  CHECK(refused == 200);
}

TEST_CASE("A polygon that runs back over itself is refused") {
  const auto spike = make_polygon({{0, 0}, {4, 0}, {4, 3}, {4, 5}, {4, 3}, {0, 3}});
  REQUIRE_FALSE(spike);
  CHECK(spike.error().message.find("(4, 5)") != std::string::npos);
  CHECK_FALSE(make_polygon({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 3}, {0, 3}}));
}
