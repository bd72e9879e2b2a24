#include "roomgen/geometry/vec.h"

#include "base/random.h"
#include "catch.h"

using namespace roomgen;

TEST_CASE("At yaw 0 the front looks to -Y and turns counter-clockwise from there") {
  //        +y
  //         |        yaw   0: v    yaw  90: >
  //         +-- +x   yaw 180: ^    yaw 270: <
  CHECK((front_direction(0) - Vec2(0, -1)).norm() < 1e-12);
  CHECK((front_direction(radians(90)) - Vec2(1, 0)).norm() < 1e-12);
  CHECK((front_direction(radians(180)) - Vec2(0, 1)).norm() < 1e-12);
  CHECK((front_direction(radians(270)) - Vec2(-1, 0)).norm() < 1e-12);
}

TEST_CASE("The yaw that faces a direction looks along it, whatever its length") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Vec2 direction = rotated({random.uniform(0.01, 5.0), 0}, random.uniform(-10.0, 10.0));
    REQUIRE((front_direction(yaw_facing(direction)) - direction.normalized()).norm() < 1e-9);
  }
}

TEST_CASE("A wrapped angle is the same direction, over -180 and up to 180 degrees") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const double angle = random.uniform(-50.0, 50.0), wrapped = wrap_angle(angle);
    REQUIRE(wrapped > -pi);
    REQUIRE(wrapped <= pi);
    REQUIRE(std::cos(angle - wrapped) == Approx(1.0));
  }
  CHECK(wrap_angle(-pi) == Approx(pi));
  CHECK(wrap_angle(3 * pi) == Approx(pi));
}

TEST_CASE("Left is a quarter turn counter-clockwise and has a positive cross product") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec2 v(random.uniform(-1, 1), random.uniform(-1, 1));
    REQUIRE((left_of(v) - rotated(v, pi / 2)).norm() < 1e-12);
    REQUIRE(cross(v, left_of(v)) >= 0.0);
  }
}
