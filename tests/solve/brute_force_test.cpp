// The second judge must itself find what is wrong.
#include "support/brute_force.h"

#include "catch.h"

using namespace roomgen;

namespace {

//  +-----window-0-----+
//  |                  |
//  |                  |
//  +--door-0----------+
Room plain_room() {
  Room room = rooms::box(4, 4);
  room.openings = {rooms::door("door-0", 0, 0.5, 1.4), rooms::window("window-0", 2, 1.0, 3.0)};
  return room;
}

std::size_t count(std::vector<Object> objects) {
  return brute_force::faults(rooms::scene(plain_room(), std::move(objects))).size();
}

}  // namespace

TEST_CASE("A sound room has no faults by brute force") {
  CHECK(count({}) == 0);
  CHECK(count({rooms::thing("bed-0", "bed", {1.6, 2.0, 0.5}, {3.1, 2.9}, 0),
               rooms::thing("plant-0", "plant", {0.4, 0.4, 0.9}, {0.3, 2.0})}) == 0);
}

TEST_CASE("Each kind of fault is found by brute force") {
  const Vec3 cube(0.5, 0.5, 1.5);
  CHECK(count({rooms::thing("a", "plant", cube, {0.24, 2})}) == 1);                       // in the wall
  CHECK(count({rooms::thing("a", "plant", {0.5, 0.5, 3}, {1, 2})}) == 1);                 // too high
  CHECK(count({rooms::thing("a", "plant", cube, {1, 0.5})}) == 1);                        // the door
  CHECK(count({rooms::thing("a", "plant", cube, {2, 3.6})}) == 1);                        // the window
  CHECK(count({rooms::thing("a", "plant", {0.5, 0.5, 0.9}, {2, 3.6})}) == 0);             // low enough
  CHECK(count({rooms::thing("a", "plant", cube, {1, 2}), rooms::thing("b", "plant", cube, {1.4, 2})}) == 2);
  CHECK(count({rooms::thing("a", "desk", {1.2, 0.6, 0.75}, {3, 0.31}, 0)}) == 1);  // front to the wall
  // A desk walled in.
  CHECK(count({rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {3.2, 3.2}, 0),
               rooms::thing("a", "plant", {2.0, 0.2, 0.8}, {3.0, 1.9}),
               rooms::thing("b", "plant", {0.2, 1.9, 0.8}, {2.1, 2.96})}) == 1);
}
