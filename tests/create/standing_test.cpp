#include "../../src/create/standing.h"

#include "catch.h"

using namespace roomgen;
using namespace roomgen::create::detail;

TEST_CASE("The hull of points, and how deep a point is in it") {
  const auto hull = convex_hull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}});
  CHECK(hull.size() == 4);
  CHECK(depth_in(hull, {0.5, 0.4}) == Approx(0.4));
  CHECK(depth_in(hull, {1.3, 1.4}) == Approx(-0.5));
}

TEST_CASE("A line has no inside") {
  CHECK(depth_in(convex_hull({{0, 0}, {1, 0}, {0.5, 0}}), {0.5, 0}) <= 0.0);
  CHECK(depth_in(convex_hull({{0, 0}}), {3, 4}) == Approx(-5));
  CHECK(depth_in({}, {0, 0}) < 0);
}
