#include "roomgen/geometry/polygon.h"

#include "catch.h"
#include "support/shapes.h"

using namespace roomgen;

TEST_CASE("Local coordinates have the width along X, and the front towards -Y") {
  //            back            yaw 90:   left
  //        +----------+                +-----+
  //  right |    ^y    | left      back |     | front  -> +x
  //        |    +->x  |                |     |
  //        +----------+                +-----+
  //           front                     right
  const Footprint f({1, 2}, {2, 1}, radians(90));
  CHECK((f.front() - Vec2(1, 0)).norm() < 1e-12);
  CHECK((f.to_world({0, -0.5}) - Vec2(1.5, 2)).norm() < 1e-12);  // middle of the front
  CHECK((f.to_world({1, 0}) - Vec2(1, 3)).norm() < 1e-12);       // middle of the left side
  CHECK(f.bounds().size().x() == Approx(1.0));
  CHECK(f.bounds().size().y() == Approx(2.0));
}

TEST_CASE("To local and back is where it was") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Footprint f = shapes::random_footprint(random, i % 2 == 0);
    const Vec2 p = shapes::random_point(random, -3, 3);
    REQUIRE((f.to_world(f.to_local(p)) - p).norm() < 1e-9);
    REQUIRE((f.to_local(p)).norm() == Approx((p - f.center()).norm()));
  }
}

TEST_CASE("A rectangle's outline is counter-clockwise with the back first and the front opposite") {
  const Footprint f({0, 0}, {2, 1}, 0.0);
  const auto o = f.outline();
  REQUIRE(o.size() == 4);
  CHECK((o[0] - Vec2(1, 0.5)).norm() < 1e-12);
  CHECK((o[1] - Vec2(-1, 0.5)).norm() < 1e-12);
  CHECK((o[2] - Vec2(-1, -0.5)).norm() < 1e-12);
  CHECK((o[3] - Vec2(1, -0.5)).norm() < 1e-12);
}

TEST_CASE("A round outline contains the ellipse and touches its box on all four sides") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Footprint f = shapes::random_footprint(random, true);
    const auto outline = f.outline();
    const std::vector<Vec2> points(outline.begin(), outline.end());
    REQUIRE(signed_area(points) > 0.0);
    for (const auto& p : shapes::sample(f, 1, 100)) {
      const Vec2 just_inside = f.center() + (1.0 - 1e-9) * (p - f.center());
      REQUIRE(shapes::winds_around(points, just_inside));
    }
    Vec2 reach = Vec2::Zero();
    for (const auto& p : points) reach = reach.cwiseMax(f.to_local(p).cwiseAbs());
    REQUIRE((reach - f.half()).norm() < 1e-9);
  }
}

TEST_CASE("The area is that of the rectangle or the ellipse") {
  CHECK(Footprint({0, 0}, {2, 1}, 0.3).area() == Approx(2.0));
  CHECK(Footprint({0, 0}, {2, 1}, 0.3, true).area() == Approx(pi / 2));
}

TEST_CASE("Containment agrees with the outline's winding number") {
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const Footprint f = shapes::random_footprint(random, false);
    const auto outline = f.outline();
    const Vec2 p = shapes::random_point(random, -3, 3);
    REQUIRE(contains(f, p) ==
            shapes::winds_around({outline.begin(), outline.end()}, p));
  }
}

TEST_CASE("A ray hits a footprint where walking along it first gets inside") {
  Random random(4);
  constexpr double step = 0.002;
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Footprint f = shapes::random_footprint(random, i % 3 == 0);
    const Vec2 origin = shapes::random_point(random, -4, 4);
    const Vec2 direction = rotated({1, 0}, random.uniform(-pi, pi));
    double walked = -1.0;
    for (double t = 0.0; t < 12.0 && walked < 0.0; t += step)
      if (contains(f, origin + t * direction)) walked = t;
    const double found = ray_hit(f, origin, direction);
    if (walked >= 0.0) {
      ++hits;
      REQUIRE(found >= 0.0);
      // The outline of round things lies up to 0.9 % outside the ellipse that contains() means.
      REQUIRE(found <= walked + 1e-6);
      if (!f.round()) REQUIRE(found >= walked - step - 1e-6);
    } else if (!f.round()) {
      // A ray that only grazes a corner may pass between two steps.
      const double inside = found < 0.0 ? 0.0 : found + 2 * step;
      REQUIRE((found < 0.0 || !contains(f, origin + inside * direction)));
    }
  }
  CHECK(hits > 30);
}

TEST_CASE("A segment passes through a footprint when one of its points is inside by the margin") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const bool round = i % 2 == 0;
    const Footprint f = shapes::random_footprint(random, round);
    const double margin = random.uniform(0.0, 0.04);
    const Footprint shrunk(f.center(), 2.0 * (f.half() - Vec2::Constant(margin)), f.yaw(), round);
    const Segment s{shapes::random_point(random, -3, 3), shapes::random_point(random, -3, 3)};
    bool enters = false;
    for (int k = 0; k <= 500 && !enters; ++k)
      enters = contains(shrunk, s.a + k / 500.0 * (s.b - s.a));
    if (enters) {
      REQUIRE(passes_through(f, s, margin));
    } else {
      // A chord shorter than the steps may be missed; a slightly smaller footprint has none.
      const Footprint smaller(f.center(), 2.0 * (shrunk.half() - Vec2::Constant(0.01)), f.yaw(), round);
      if (smaller.half().minCoeff() > 0.02) REQUIRE_FALSE(passes_through(smaller, s));
    }
  }
}
