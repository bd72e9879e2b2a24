#include "catch.h"
#include "geometry/inside.h"
#include "roomgen/geometry/polygon.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

double distance_by_edges(const Polygon& polygon, const Vec2& p) {
  double best = 1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    for (int i = 0; i <= 1000; ++i) {
      const Segment e = polygon.edge(k);
      best = std::min(best, (e.a + i / 1000.0 * (e.b - e.a) - p).norm());
    }
  return best;
}

}  // namespace

TEST_CASE("Points are inside when the polygon winds around them") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const auto polygon = shapes::random_star(random, {0, 0}, 0.5, 4, random.integer(3, 12));
    for (int j = 0; j < 50; ++j) {
      const Vec2 p = shapes::random_point(random, -4, 4);
      REQUIRE(contains(polygon, p) == shapes::winds_around(polygon.points, p));
    }
  }
}

TEST_CASE("The distance of a point to the boundary is that to the nearest point on an edge") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const auto polygon = shapes::random_star(random, {0, 0}, 0.5, 4, 7);
    const Vec2 p = shapes::random_point(random, -4, 4);
    REQUIRE(distance_to_boundary(polygon, p) ==
            Approx(distance_by_edges(polygon, p)).margin(0.004));
  }
}

TEST_CASE("A footprint is inside when all its sampled points are") {
  Random random(3);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto polygon = shapes::random_star(random, {0, 0}, 1.5, 4, random.integer(3, 9));
    const bool round = i % 3 == 0;
    const Footprint f(shapes::random_point(random, -2, 2), shapes::random_point(random, 0.2, 2.0),
                      random.uniform(-pi, pi), round);
    bool all = true, clearly_out = false;
    for (const auto& p : shapes::sample(f, 3, 120)) {
      if (shapes::winds_around(polygon.points, p)) continue;
      all = false;
      clearly_out = clearly_out || distance_to_boundary(polygon, p) > 0.02;
    }
    INFO("case " << i);
    if (clearly_out) REQUIRE_FALSE(contains(polygon, f));
    // A corner of the polygon may poke into the footprint between two samples, by less than a step.
    if (all && distance_to_boundary(polygon, f) > 0.0) REQUIRE(contains(polygon, f));
    inside += all ? 1 : 0;
  }
  CHECK(inside > 300);
}

TEST_CASE("A footprint in the notch of an L is outside although its corners are inside") {
  //  +--------+
  //  |  ####  |      the thing spans the notch between both arms of the U
  //  +-+####+-+
  //  | |####| |
  //  +-+    +-+
  const Polygon u{{{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 0}, {4, 0}, {4, 3}, {0, 3}}};
  CHECK_FALSE(contains(u, Footprint({2, 1.9}, {3.6, 1.9}, 0.0)));
  CHECK(contains(u, Footprint({2, 2.5}, {3.6, 0.9}, 0.0)));
  // As deep as the bar and no deeper.
  CHECK(contains(u, Footprint({2, 2.5}, {4, 1}, 0.0)));
  CHECK_FALSE(contains(u, Footprint({2, 2.498}, {4, 1}, 0.0)));
}

TEST_CASE("The tolerance lets a footprint cross the wall by so much and no more") {
  const Polygon square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const auto at = [](double x) { return Footprint({x, 2}, {1, 1}, 0.0); };
  CHECK(contains(square, at(0.5)));
  CHECK(contains(square, at(0.4995), 0.001));
  CHECK_FALSE(contains(square, at(0.4985), 0.001));
  CHECK(contains(square, at(0.4985), 0.01));
}

TEST_CASE("The distance of a footprint to the boundary is 0 exactly when it touches a wall") {
  const Polygon square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  for (int degree = 0; degree < 180; degree += 11) {
    for (bool round : {false, true}) {
      const Footprint f({2, 2}, {1.2, 0.6}, radians(degree), round);
      const double reach = f.bounds().high.x() - 2.0;
      INFO("yaw " << degree);
      CHECK(distance_to_boundary(square, f) ==
            Approx(2.0 - std::max(reach, f.bounds().high.y() - 2.0)).margin(1e-9));
      const Footprint at_wall({reach, 2}, {1.2, 0.6}, radians(degree), round);
      CHECK(distance_to_boundary(square, at_wall) == Approx(0.0).margin(1e-9));
    }
  }
}

TEST_CASE("What looks at the edges near a height finds the same points inside") {
  Random random(2);
  for (const int corners : {3, 4, 7, 40, 300}) {
    const auto polygon = shapes::random_star(random, {0, 0}, 0.5, 4, corners);
    const Inside inside(polygon);
    int found = 0;
    for (int j = 0; j < 2000; ++j) {
      const Vec2 p = shapes::random_point(random, -4.2, 4.2);
      REQUIRE(inside.contains(p) == contains(polygon, p));
      found += inside.contains(p);
    }
    CHECK(found > 0);
    // At the very heights of corners, where edges begin and end.
    for (const Vec2& corner : polygon.points)
      for (const double x : {-5.0, 0.0, corner.x(), 5.0})
        REQUIRE(inside.contains({x, corner.y()}) == contains(polygon, Vec2(x, corner.y())));
  }
}
