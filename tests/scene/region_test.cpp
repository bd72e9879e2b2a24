#include "scene/room_part.h"

#include <random>

#include "support/held.h"

using namespace roomgen;

namespace {

Scene hall(double width = 6, double depth = 4) {
  return rooms::scene(rooms::box(width, depth), {});
}

Object chest(double x, double y, double yaw = 0) {
  return rooms::thing("chest-0", "thing", {0.8, 0.4, 0.5}, {x, y}, yaw);
}

bool is_in(const Scene& scene, const Object& object, const std::string& region) {
  return judged(scene, object, "in part, " + region).held;
}

}  // namespace

TEST_CASE("A region is a share of the floor's box at a side or across the longer one") {
  const Room room = hall().room;
  const auto area = [&](const char* name) {
    const auto region = region_of_room(room, name);
    return region ? 4 * region->half().prod() : 0.0;
  };
  CHECK(area("north-half") == Approx(12));
  CHECK(area("west-third") == Approx(8));
  CHECK(area("south-two-thirds") == Approx(16));
  CHECK(area("east-quarter") == Approx(6));
  CHECK(area("north-east-quarter") == Approx(6));
  CHECK(area("middle-third") == Approx(8));
  CHECK((region_of_room(room, "north-east-quarter")->center() - Vec2(4.5, 3)).norm() < 1e-9);
  CHECK((region_of_room(room, "middle-third")->center() - Vec2(3, 2)).norm() < 1e-9);
  for (const char* none : {"", "half", "-half", "north", "north-", "up-half", "north-south-quarter",
                           "north-east-half", "northhalf", "middle-east-quarter"})
    CHECK_FALSE(region_of_room(room, none));
  for (const auto& name : region_names()) CHECK(region_of_room(room, name));
}

TEST_CASE("in part: the centre counts, anywhere in the region is as good, nearer is better outside") {
  const Scene scene = hall();
  CHECK(is_in(scene, chest(1, 2.1), "north-half"));
  CHECK_FALSE(is_in(scene, chest(1, 1.9), "north-half"));
  CHECK(is_in(scene, chest(1, 2.0), "north-half"));  // on the line
  CHECK(is_in(scene, chest(1, 2.0), "south-half"));
  CHECK(judged(scene, chest(5, 3.5), "in part, north-half").degree == 1.0);
  CHECK(judged(scene, chest(5, 1.5), "in part, north-half").degree >
        judged(scene, chest(5, 0.5), "in part, north-half").degree);
}

TEST_CASE("The halves, the thirds and the quarters cover every place, opposite ones none twice") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0, 1);
  for (int n = 0; n < 300; ++n) {
    const double w = 2 + 8 * u(random), d = 2 + 8 * u(random);
    const Scene scene = hall(w, d);
    const Object object = chest(w * u(random), d * u(random), 360 * u(random));
    const auto in = [&](const char* name) { return static_cast<int>(is_in(scene, object, name)); };
    CHECK(in("north-half") + in("south-half") == 1);
    CHECK(in("east-half") + in("west-half") == 1);
    CHECK(in("north-east-quarter") + in("north-west-quarter") + in("south-east-quarter") +
              in("south-west-quarter") == 1);
    CHECK(in("south-two-thirds") + in("north-third") == 1);
    const bool is_wide = w >= d;
    CHECK(in("middle-third") + in(is_wide ? "west-third" : "south-third") +
              in(is_wide ? "east-third" : "north-third") == 1);
    CHECK(in("north-east-quarter") == in("north-half") * in("east-half"));
  }
}

//  [bed-0]      [bed-1]
//   1..2         4..5
TEST_CASE("between: beyond the one and before the other, not aside of both") {
  const Scene scene = rooms::scene(
      rooms::box(6, 6), {rooms::thing("bed-0", "bed", {1, 2, 0.5}, {1.5, 3}, 0),
                         rooms::thing("bed-1", "bed", {1, 2, 0.5}, {4.5, 3}, 0)});
  const std::string both = "between, bed-0 | between, bed-1";
  CHECK(held(scene, chest(3, 3), both));
  CHECK(held(scene, chest(3, 3.95, 90), both));
  CHECK(held(scene, chest(2.1, 2.1), both));
  CHECK_FALSE(held(scene, chest(3, 4.1), both));   // aside
  CHECK_FALSE(held(scene, chest(1.9, 3), both));   // over the one
  CHECK_FALSE(held(scene, chest(5.3, 3), both));   // beyond the other
  CHECK_FALSE(held(scene, chest(3, 3), "between, bed-0"));  // of one alone it cannot be
  CHECK(judged(scene, chest(3, 3), both).degree > judged(scene, chest(2.2, 3.5), both).degree);
  CHECK(judged(scene, chest(3, 3), "between, bed-1 | between, bed-0").held);
}
