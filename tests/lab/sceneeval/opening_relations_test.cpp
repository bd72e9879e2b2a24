#include "base/random.h"
#include "catch.h"
#include "lab/sceneeval/geometric_relations.h"
#include "roomgen/lab/scores.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

// A window from 2 to 3.5 in the north wall of five by four, a door from 1 to 2 in the south wall.
Room five_by_four() {
  Room room = rooms::box(5, 4);
  room.openings = {rooms::door("door-0", 0, 1, 2), rooms::window("window-0", 2, 1.5, 3)};
  return room;
}

Object hung(const Vec3& size, const Vec2& at, double yaw, double height) {
  Object object = rooms::thing("a-0", "thing", size, at, yaw);
  object.position.z() = height;
  return object;
}

Thing made(const Object& object) {
  return thing_of(object, ModelTable());
}

Thing standing(const Vec3& size, const Vec2& at, double yaw = 0.0) {
  return made(rooms::thing("a-0", "thing", size, at, yaw));
}

}  // namespace

TEST_CASE("A low desk faces the window that its front meets") {
  const RoomThings parts = room_things(five_by_four());
  const Vec3 desk(1.2, 0.6, 0.7);
  CHECK(face_opening(standing(desk, {2.7, 2}, 180), parts.windows) == 1.0);
  CHECK(face_opening(standing(desk, {2.7, 2}, 0), parts.windows) == 0.0);  // its back to it
  CHECK(face_opening(standing(desk, {2.7, 2}, 90), parts.windows) == 0.0);
  CHECK(face_opening(standing(desk, {4.4, 2}, 180), parts.windows) == 0.0);  // past it
  CHECK(face_opening(standing(desk, {1.5, 2}, 0), parts.doors) == 1.0);
  CHECK(face_opening(standing(desk, {4, 3}, -40), parts.doors) > 0.9);
  CHECK(face_opening(standing(desk, {4, 3}, 0), parts.doors) == 0.0);
  CHECK(face_opening(standing(desk, {4, 3}, -40), {}) == 0.0);
}

TEST_CASE("Facing an opening agrees with rays from all over the thing's width") {
  Random random(4);
  const RoomThings parts = room_things(five_by_four());
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const double width = random.uniform(0.3, 1.8);
    const double x = random.uniform(0.5, 4.5);
    const double y = random.uniform(0.5, 3.5);
    const double yaw = random.uniform(-180, 180);
    const Vec2 front = front_direction(radians(yaw));
    const Vec2 side = left_of(front);
    Vec2 sum = Vec2::Zero();
    int hits = 0;
    for (int k = 0; k < 1001; ++k) {
      const Vec2 from = Vec2(x, y) + (k / 1000.0 - 0.5) * width * side;
      if (front.y() <= 1e-3) continue;
      const Vec2 hit = from + (4 - from.y()) / front.y() * front;
      if (hit.x() < 2 || hit.x() > 3.5) continue;
      sum += hit;
      ++hits;
    }
    const Vec2 towards = hits > 0 ? Vec2(sum / hits - Vec2(x, y)) : Vec2(-front);
    const double off = degrees(std::acos(std::clamp(towards.normalized().dot(front), -1.0, 1.0)));
    CHECK(face_opening(standing({width, 0.01, 0.7}, {x, y}, yaw), parts.windows) ==
          Approx(std::clamp(1 - off / 30, 0.0, 1.0)).margin(0.02));
    met += hits > 0;
  }
  CHECK(met > 30);
}

TEST_CASE("A wall is faced squarely or not") {
  const RoomThings parts = room_things(five_by_four());
  for (const double yaw : {0.0, 20.0, -25.0, 70.0, 100.0, 180.0})
    CHECK(face_wall(standing({0.5, 0.5, 1}, {2.5, 2}, yaw), parts.walls) > 0.5);
  for (const double yaw : {45.0, -40.0, 130.0})
    CHECK(face_wall(standing({0.5, 0.5, 1}, {2.5, 2}, yaw), parts.walls) < 0.5);
}

TEST_CASE("On a door or a window is what covers it, or hangs on it") {
  const RoomThings parts = room_things(five_by_four());
  const auto on_window = [&](const Vec3& size, const Vec2& at, double yaw, double height) {
    return on_opening(made(hung(size, at, yaw, height)), parts.windows);
  };
  CHECK(on_window({2.2, 0.1, 2.2}, {2.75, 3.94}, 0, 0.2) ==
        1.0);  // a curtain wider than the window
  CHECK(on_window({0.4, 0.02, 0.4}, {2.4, 3.97}, 0, 1.3) == 1.0);  // a sign on the pane
  CHECK(on_window({0.4, 0.02, 0.4}, {1.9, 3.97}, 0, 1.3) < 0.5);   // beside it
  CHECK(on_window({0.4, 0.02, 0.4}, {2.4, 3.7}, 0, 1.3) == 0.0);   // before it
  CHECK(on_window({0.4, 0.02, 0.4}, {2.4, 3.97}, 0, 0.2) == 0.0);  // below it
  CHECK(on_window({2.2, 0.1, 2.2}, {0.06, 2}, 90, 0.2) == 0.0);    // on another wall
  CHECK(on_opening(made(hung({0.9, 0.05, 0.6}, {1.5, 0.03}, 180, 1.4)), parts.doors) == 1.0);
}

TEST_CASE("Left and right of a door, as seen from the room") {
  const RoomThings parts = room_things(five_by_four());
  const auto beside = [&](double x, double y, BoxSide side) {
    return beside_opening(made(hung({0.4, 0.02, 0.6}, {x, y}, 180, 1.3)), parts.doors, side) > 0.5;
  };
  // Who looks at the door in the south wall has the east at the left.
  CHECK(beside(2.4, 0.01, BoxSide::left));
  CHECK_FALSE(beside(2.4, 0.01, BoxSide::right));
  CHECK(beside(0.5, 0.01, BoxSide::right));
  CHECK_FALSE(beside(1.5, 0.01, BoxSide::left));  // on it
  CHECK_FALSE(beside(4.6, 0.01, BoxSide::left));  // far away
  CHECK_FALSE(beside(2.4, 1.0, BoxSide::left));   // out in the room
  CHECK_FALSE(beside(2.4, 3.99, BoxSide::left));  // at the wall opposite
}

TEST_CASE("On the floor, or on a rug there") {
  CHECK(on_floor(standing({1, 1, 1}, {1, 1})) == 1.0);
  CHECK(on_floor(made(hung({1, 1, 1}, {1, 1}, 0, 0.02))) == 1.0);
  CHECK(on_floor(made(hung({1, 1, 1}, {1, 1}, 0, 0.4))) == 0.0);
}

TEST_CASE("Rows may ask what faces, covers and flanks openings, and what is on the floor") {
  const auto rows = parse_requirements(
      "ID,Description,ObjCount,OARel\n1,x,\"eq,1,desk\",\"eq,1,facing,desk,window;eq,1,facing,desk,"
      "door;"
      "eq,1,facing,desk,wall;eq,1,on,desk,floor;eq,1,on,desk,window;eq,1,right,desk,door\"\n",
      "r");
  REQUIRE(rows);
  const Scene scene = rooms::scene(
      five_by_four(), {rooms::thing("desk-0", "desk", {1.2, 0.6, 0.75}, {2.7, 2}, 180)});
  const auto verdicts = score_room(rows->front(), scene, ModelTable()).room_relations;
  std::vector<bool> held;
  for (const auto& verdict : verdicts) held.push_back(verdict.satisfied);
  CHECK(held == std::vector<bool>{true, false, true, true, false, false});
}
