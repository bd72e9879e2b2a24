#include "geometry/convex_hull.h"

#include "catch.h"
#include "roomgen/geometry/polygon.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

std::vector<Vec2> random_points(Random& random) {
  std::vector<Vec2> points;
  for (int k = random.integer(3, 60); k > 0; --k) {
    Vec2 point = shapes::random_point(random, -2, 2);
    if (random.chance(0.3)) point = point.array().round();  // many in line, many equal
    points.push_back(point);
  }
  return points;
}

}  // namespace

TEST_CASE("A hull is convex, has its corners from the points and all points in it") {
  Random random(1);
  for (int n = 0; n < 300; ++n) {
    const auto points = random_points(random);
    const auto hull = convex_hull(points);
    if (hull.size() < 3) continue;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Vec2 &a = hull[k], &b = hull[(k + 1) % hull.size()], &c = hull[(k + 2) % hull.size()];
      REQUIRE(cross(b - a, c - b) > 0.0);
      REQUIRE(std::find(points.begin(), points.end(), a) != points.end());
    }
    for (const auto& point : points) REQUIRE(depth_in(hull, point) > -1e-12);
  }
}

TEST_CASE("No smaller set of the points has them all: without a corner one of them is outside") {
  Random random(2);
  for (int n = 0; n < 100; ++n) {
    const auto hull = convex_hull(random_points(random));
    for (std::size_t k = 0; hull.size() > 3 && k < hull.size(); ++k) {
      auto fewer = hull;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      REQUIRE(depth_in(fewer, hull[k]) < 0.0);
    }
  }
}

TEST_CASE("Points in one line have a hull of two ends and no inside") {
  CHECK(convex_hull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}}).size() == 4);
  const auto line = convex_hull({{0, 0}, {1, 0}, {0.5, 0}, {1, 0}});
  CHECK(line.size() == 2);
  CHECK(depth_in(line, {0.5, 0}) <= 0.0);
  CHECK(depth_in(line, {0.5, 2}) == Approx(-2));
  CHECK(depth_in(convex_hull({{0, 0}, {0, 0}}), {3, 4}) == Approx(-5));
  CHECK(depth_in({}, {0, 0}) < 0.0);
}

TEST_CASE("The depth is the distance to the nearest side, inside and outside") {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    const auto hull = convex_hull(random_points(random));
    if (hull.size() < 3) continue;
    const Vec2 point = shapes::random_point(random, -3, 3);
    const double depth = depth_in(hull, point);
    CHECK(std::abs(depth) == Approx(distance_to_boundary(Polygon{hull}, point)));
    if (std::abs(depth) > 1e-9) CHECK((depth > 0) == shapes::winds_around(hull, point));
  }
}
