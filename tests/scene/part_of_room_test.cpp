#include "scene/room_part.h"

#include "support/held.h"

using namespace roomgen;

namespace {

//  3----window-0---2
//  |               |
//  |               |
//  0--door-0-------1
Scene with_openings() {
  Scene scene = rooms::scene(rooms::box(6, 4), {});
  scene.room.openings = {rooms::door("door-0", 0, 1, 2), rooms::window("window-0", 2, 2, 4)};
  return scene;
}

Object chair(double x, double y, double yaw = 0) {
  return rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {x, y}, yaw);
}

}  // namespace

TEST_CASE("Doors, windows and walls are things without depth that look into the room") {
  const Room room = with_openings().room;
  const auto door = part_of_room(room, "door-0");
  REQUIRE(door);
  CHECK((door->center() - Vec2(1.5, 0)).norm() < 1e-9);
  CHECK(2 * door->half().x() == Approx(1.0));
  CHECK(2 * door->half().y() < 0.01);
  CHECK((door->front() - Vec2(0, 1)).norm() < 1e-9);
  const auto wall = part_of_room(room, "wall-1");
  REQUIRE(wall);
  CHECK((wall->center() - Vec2(6, 2)).norm() < 1e-9);
  CHECK((wall->front() - Vec2(-1, 0)).norm() < 1e-9);
  CHECK_FALSE(part_of_room(room, "wall-4"));
  CHECK_FALSE(part_of_room(room, "door-1"));
  CHECK_FALSE(part_of_room(room, ""));
}

TEST_CASE("Positions against parts of the room") {
  const Scene scene = with_openings();
  CHECK(held(scene, chair(1.5, 1), "in front of, door-0"));
  CHECK_FALSE(held(scene, chair(2.6, 1), "in front of, door-0"));
  CHECK(held(scene, chair(3, 3), "in front of, window-0"));
  CHECK(held(scene, chair(3, 2), "face to, door-0") == false);
  CHECK(held(scene, chair(1.5, 2, 0), "face to, door-0"));
  CHECK(held(scene, chair(1.5, 2, 180), "face to, wall-2"));
  CHECK(held(scene, chair(3, 2, 180), "face to, window-0"));
  CHECK(held(scene, chair(1.5, 1.7), "near, door-0"));
  CHECK_FALSE(held(scene, chair(1.5, 1.8), "near, door-0"));
  CHECK(held(scene, chair(5, 3), "far, door-0"));
}

TEST_CASE("A corner is whichever serves best, inner ones not among them") {
  //  +---+
  //  |   |
  //  +   +---+      the reflex corner at (2, 2) is none
  //  |       |
  //  +-------+
  Scene l = rooms::scene(rooms::box(1, 1), {});
  l.room.polygon.points = {{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}};
  CHECK(held(l, chair(7.5, 3.5), "near, corner"));
  CHECK(held(l, chair(0.5, 0.5), "near, corner"));
  CHECK_FALSE(held(l, chair(4, 3.5), "near, corner"));
}
