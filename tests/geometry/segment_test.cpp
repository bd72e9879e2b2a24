#include "roomgen/geometry/polygon.h"

#include "catch.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

double distance_by_sampling(const Segment& s, const Segment& t) {
  double best = 1e300;
  for (int i = 0; i <= 400; ++i) {
    const Vec2 p = s.a + i / 400.0 * (s.b - s.a);
    for (int j = 0; j <= 400; ++j) best = std::min(best, (t.a + j / 400.0 * (t.b - t.a) - p).norm());
  }
  return best;
}

}  // namespace

TEST_CASE("The distance of two segments is that of their nearest points") {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Segment s{shapes::random_point(random, -1, 1), shapes::random_point(random, -1, 1)};
    const Segment t{shapes::random_point(random, -1, 1), shapes::random_point(random, -1, 1)};
    const double sampled = distance_by_sampling(s, t), found = distance(s, t);
    REQUIRE(found <= sampled + 1e-9);
    REQUIRE(found >= sampled - 0.008);  // the samples are up to 0.0071 m apart
    REQUIRE(intersects(s, t) == (found == 0.0));
  }
}

TEST_CASE("Segments that touch at an end or lie over each other intersect") {
  //   +-----+-----+      touching, and overlapping in line
  const Segment line{{0, 0}, {2, 0}};
  CHECK(intersects(line, {{2, 0}, {3, 1}}));
  CHECK(intersects(line, {{1, 0}, {1, 1}}));
  CHECK(intersects(line, {{1, 0}, {3, 0}}));
  CHECK(intersects(line, {{0.5, 0}, {1.5, 0}}));
  CHECK_FALSE(intersects(line, {{2.001, 0}, {3, 0}}));
  CHECK_FALSE(intersects(line, {{0, 0.001}, {2, 0.001}}));
}

TEST_CASE("A segment without length is a point") {
  const Segment point{{1, 1}, {1, 1}};
  CHECK(distance(point, Vec2(1, 3)) == Approx(2.0));
  CHECK(distance(point, Segment{{0, 0}, {2, 0}}) == Approx(1.0));
}
