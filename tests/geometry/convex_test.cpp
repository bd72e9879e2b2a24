#include "roomgen/geometry/convex.h"

#include "catch.h"
#include "roomgen/base/random.h"

using namespace roomgen;

namespace {

Polygon random_polygon(Random& random) {
  // Star-shaped around its middle, so simple; often not convex.
  const Vec2 middle(random.uniform(-1, 1), random.uniform(-1, 1));
  Polygon polygon;
  const int n = random.integer(3, 9);
  for (int k = 0; k < n; ++k)
    polygon.points.push_back(middle + rotated(Vec2(random.uniform(0.3, 2.0), 0), 2 * pi * k / n));
  return polygon;
}

}  // namespace

TEST_CASE("What is left of a tile is the tile without the hole, point by point") {
  Random random(1);
  for (int n = 0; n < 200; ++n) {
    const Polygon tile = random_polygon(random), hole = random_polygon(random);
    const auto left = subtract({tile}, hole);
    for (int k = 0; k < 60; ++k) {
      const Vec2 point(random.uniform(-3, 3), random.uniform(-3, 3));
      int times = 0;
      double apart = std::min(distance_to_boundary(tile, point), distance_to_boundary(hole, point));
      for (const auto& piece : left) {
        times += contains(piece, point);
        apart = std::min(apart, distance_to_boundary(piece, point));
      }
      if (apart < 1e-6) continue;
      CHECK(times == (contains(tile, point) && !contains(hole, point) ? 1 : 0));
    }
  }
}

TEST_CASE("A hole elsewhere leaves a tile as it is") {
  Polygon tile, far;
  tile.points = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  far.points = {{5, 5}, {6, 5}, {6, 6}};
  const auto left = subtract({tile}, far);
  REQUIRE(left.size() == 1);
  CHECK(left[0].points == tile.points);
  CHECK(subtract({tile}, tile).empty());
}
