#include "support/held.h"

using namespace roomgen;

namespace {

//      +----+         The television is 1 m wide at (4, 6); the seat at (4, 2) looks up at yaw 180.
//      | tv |
//      +----+
//         ^
//       [seat]
Scene with_tv() {
  return rooms::scene(rooms::box(8, 8), {rooms::thing("tv-0", "thing", {1, 0.4, 0.6}, {4, 6}, 20)});
}

Object seat(double yaw, double x = 4) {
  return rooms::thing("seat-0", "thing", {0.6, 0.6, 0.8}, {x, 2}, yaw);
}

}  // namespace

TEST_CASE("face to: the ray along the front meets the target") {
  CHECK(held(with_tv(), seat(180), "face to, tv-0"));
  CHECK(held(with_tv(), seat(180 + 6), "face to, tv-0"));
  CHECK_FALSE(held(with_tv(), seat(180 + 10), "face to, tv-0"));
  CHECK_FALSE(held(with_tv(), seat(0), "face to, tv-0"));
  CHECK_FALSE(held(with_tv(), seat(180, 5), "face to, tv-0"));
}

TEST_CASE("used facing: who uses it looks at the target, over a desk and at a television's viewer alike") {
  const auto thing = [](const char* category, double yaw) {
    return rooms::thing("x-0", category, {1.2, 0.6, 0.8}, {4, 2}, yaw);
  };
  for (const char* category : {"desk", "treadmill", "upright piano", "standing desk"}) {
    INFO(category);
    CHECK(held(with_tv(), thing(category, 0), "used facing, tv-0"));  // its front, the user's side, is away from it
    CHECK(held(with_tv(), thing(category, 6), "used facing, tv-0"));
    CHECK_FALSE(held(with_tv(), thing(category, 180), "used facing, tv-0"));
  }
  for (const char* category : {"tv", "sofa", "mirror", "stove", "reception desk", "vanity", "thing"}) {
    INFO(category);
    CHECK(held(with_tv(), thing(category, 180), "used facing, tv-0"));
    CHECK_FALSE(held(with_tv(), thing(category, 0), "used facing, tv-0"));
  }
}

TEST_CASE("face same as and face opposite to compare the yaws, within a degree, whatever the turns") {
  for (double turn : {0.0, 360.0, -720.0}) {
    CHECK(held(with_tv(), seat(20.9 + turn), "face same as, tv-0"));
    CHECK_FALSE(held(with_tv(), seat(21.1 + turn), "face same as, tv-0"));
    CHECK_FALSE(held(with_tv(), seat(200 + turn), "face same as, tv-0"));
    CHECK(held(with_tv(), seat(199.1 + turn), "face opposite to, tv-0"));
    CHECK_FALSE(held(with_tv(), seat(198.9 + turn), "face opposite to, tv-0"));
    CHECK_FALSE(held(with_tv(), seat(20 + turn), "face opposite to, tv-0"));
  }
}

TEST_CASE("Facing better has a better degree, also before it holds") {
  double last = -1.0;
  for (double yaw = 0.0; yaw <= 180.0; yaw += 10.0) {
    const double degree = judged(with_tv(), seat(yaw), "face to, tv-0").degree;
    CHECK(degree > last);
    last = degree;
  }
}
