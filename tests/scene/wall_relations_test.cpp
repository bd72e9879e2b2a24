#include "support/held.h"

using namespace roomgen;

namespace {

//  +---------- 6 m ----------+
//  |                         |  5 m
//  +-------------------------+
const Scene room = rooms::scene(rooms::box(6, 5), {});

// A dresser of 1.0 x 0.4 with its back to the upper wall (y = 5), `gap` away from it.
Object at_upper_wall(double gap, double x = 3, double turn = 0) {
  return rooms::thing("dresser-0", "dresser", {1.0, 0.4, 0.8}, {x, 5 - 0.2 - gap}, turn);
}

}  // namespace

TEST_CASE("edge: the back is parallel to a wall, near it and turned to it") {
  //  =======    =======    =======    =======
  //  [back ]    [     ]    [front]     / slanted
  //   front      5 cm       back      /
  CHECK(held(room, at_upper_wall(0.0), "edge"));
  CHECK(held(room, at_upper_wall(0.05), "edge"));
  CHECK_FALSE(held(room, at_upper_wall(0.051), "edge"));
  CHECK(held(room, at_upper_wall(0.02, 3, 0.9), "edge"));
  CHECK_FALSE(held(room, at_upper_wall(0.02, 3, 1.5), "edge"));
  CHECK_FALSE(held(room, at_upper_wall(0.02, 3, 180), "edge"));
  CHECK_FALSE(held(room, rooms::thing("a-0", "a", {1.0, 0.4, 0.8}, {3, 4.5}, 90), "edge"));
  CHECK_FALSE(held(room, at_upper_wall(1.0), "edge"));
}

TEST_CASE("edge: the middle of the back lies beside the wall, not beyond its end") {
  //  An inner wall of 1 m at x = 3, thing centred 0.4 m before or 0.2 m beyond its lower end.
  //  +-----+-----+
  //  |     | <[]       corner at (3, 4)
  //  |     +  <[]
  //  |           |
  Scene notched = room;
  notched.room.polygon.points = {{0, 0}, {6, 0}, {6, 5}, {3, 5}, {3, 4}, {0, 4}};
  const auto beside = [&](double y) {
    return rooms::thing("a-0", "a", {0.6, 0.4, 0.8}, {3.2, y}, 90);
  };
  CHECK(held(notched, beside(4.4), "edge"));
  CHECK(held(notched, beside(4.05), "edge"));
  CHECK_FALSE(held(notched, beside(3.9), "edge"));
}

TEST_CASE("middle: the whole footprint keeps 0.30 m from every wall") {
  const auto at = [](double x) { return rooms::thing("a-0", "a", {1, 1, 1}, {x, 2.5}); };
  CHECK(held(room, at(3), "middle"));
  CHECK(held(room, at(0.8), "middle"));
  CHECK_FALSE(held(room, at(0.79), "middle"));
  // Its corner counts, not its side.
  const double reach = std::sqrt(0.5);
  CHECK(held(room, rooms::thing("a-0", "a", {1, 1, 1}, {0.301 + reach, 2.5}, 45), "middle"));
  CHECK_FALSE(held(room, rooms::thing("a-0", "a", {1, 1, 1}, {0.299 + reach, 2.5}, 45), "middle"));
}

TEST_CASE("corner: at a wall, and one side within 0.10 m of another") {
  //  +=========
  //  | [back ]
  //  |  front
  const double flush = 0.5;
  CHECK(held(room, at_upper_wall(0.01, flush + 0.05), "corner"));
  CHECK(held(room, at_upper_wall(0.01, 6 - flush - 0.1), "corner"));
  CHECK_FALSE(held(room, at_upper_wall(0.01, flush + 0.11), "corner"));
  CHECK_FALSE(held(room, at_upper_wall(0.06, flush + 0.05), "corner"));
  CHECK_FALSE(held(room, at_upper_wall(0.01, flush + 0.05, 180), "corner"));
}

TEST_CASE("A better distance to the wall has a better degree") {
  double last = 2.0;
  for (double gap = 0.0; gap < 1.0; gap += 0.05) {
    const double degree = judged(room, at_upper_wall(gap), "edge").degree;
    CHECK(degree < last);
    last = degree;
  }
}
