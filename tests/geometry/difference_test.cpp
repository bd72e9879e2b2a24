#include "base/random.h"
#include "catch.h"
#include "geometry/triangulate.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

// Holes run clockwise: they count against the loop around them.
int times_inside(const std::vector<Loop>& loops, const Vec2& point) {
  int times = 0;
  for (const auto& loop : loops)
    if (contains(Polygon{loop}, point)) times += signed_area(loop) > 0 ? 1 : -1;
  return times;
}

double distance_to(const std::vector<Loop>& loops, const Vec2& point) {
  double nearest = 1e9;
  for (const auto& loop : loops)
    nearest = std::min(nearest, distance_to_boundary(Polygon{loop}, point));
  return nearest;
}

}  // namespace

TEST_CASE("What is left of a polygon is the polygon without the others, point by point") {
  Random random(1);
  for (int n = 0; n < 200; ++n) {
    const auto star = [&] {
      const Vec2 middle = shapes::random_point(random, -1, 1);
      return shapes::random_star(random, middle, 0.3, 2.0, random.integer(3, 9));
    };
    const Polygon tile = star();
    const std::vector<Polygon> others(1, star());
    const auto left = difference(tile, others);
    for (int k = 0; k < 60; ++k) {
      const Vec2 point = shapes::random_point(random, -3, 3);
      if (std::min(distance_to({tile.points, others[0].points}, point), distance_to(left, point)) < 1e-5)
        continue;
      CHECK(times_inside(left, point) == (contains(tile, point) && !contains(others[0], point) ? 1 : 0));
    }
  }
}

TEST_CASE("What overlaps nothing is left as it is, and nothing is left of a polygon without itself") {
  Polygon tile, far;
  tile.points = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  far.points = {{5, 5}, {6, 5}, {6, 6}};
  const auto left = difference(tile, std::vector{far});
  REQUIRE(left.size() == 1);
  CHECK(left[0] == tile.points);
  CHECK(difference(tile, std::vector{tile}).empty());
}

TEST_CASE("A hole in the middle is a loop of its own, and triangles go around it") {
  const Polygon tile{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}}, hole{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  const auto left = difference(tile, std::vector{hole});
  REQUIRE(left.size() == 2);
  std::vector<Vec2> points;
  for (const auto& loop : left) points.insert(points.end(), loop.begin(), loop.end());
  double sum = 0.0;
  for (const auto& t : triangulate(left)) sum += signed_area({points[t[0]], points[t[1]], points[t[2]]});
  CHECK(sum == Approx(11.0));
}
