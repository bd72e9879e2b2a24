#include "roomgen/scene/room.h"

#include "catch.h"
#include "support/rooms.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

bool covered(const std::vector<Footprint>& areas, const Vec2& p) {
  for (const auto& area : areas)
    if (contains(area, p)) return true;
  return false;
}

}  // namespace

TEST_CASE("Before a door lies a rectangle as wide as it, on the inside") {
  //  +-----------+
  //  |  +---+    |
  //  |  |   |0.9 |
  //  +--=====----+
  //    1.0   1.8
  Room room = rooms::box(4, 3);
  room.openings = {rooms::door("door-0", 0, 1.0, 1.8)};
  const auto area = door_clearance(room, room.openings[0]);
  CHECK((area.bounds().low - Vec2(1.0, 0)).norm() < 1e-9);
  CHECK((area.bounds().high - Vec2(1.8, 0.9)).norm() < 1e-9);
  room.openings[0].swing = DoorSwing::out;
  CHECK((door_clearance(room, room.openings[0]).bounds().high - Vec2(1.8, 0.6)).norm() < 1e-9);
  room.openings[0].swing = DoorSwing::in;
  room.openings[0].type = OpeningType::passage;
  CHECK((door_clearance(room, room.openings[0]).bounds().high - Vec2(1.8, 0.6)).norm() < 1e-9);
}

TEST_CASE("Clearances lie inside the room on every wall at any angle") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    Room room = rooms::box(6, 5);
    room = rooms::moved(room, random.uniform(-pi, pi), shapes::random_point(random, -9, 9));
    const auto wall = static_cast<std::size_t>(random.integer(0, 3));
    const auto window = rooms::window("window-0", wall, 1.5, 2.5);
    const auto area = window_clearance(room, window);
    CHECK(contains(room.polygon, area));
    CHECK(distance(segment(room, window), area.center()) == Approx(0.25));
    CHECK((area.front() - inward(room, window)).norm() < 1e-9);
  }
}

TEST_CASE("The leaf of a wide door is free to swing, on the side of its hinge") {
  //  hinge at from              hinge at to
  //  h........ .                . ........h
  for (double width : {0.7, 0.9, 1.0, 1.2, 1.5})
    for (bool at_from : {true, false}) {
      Room room = rooms::box(4, 4);
      room.openings = {rooms::door("door-0", 0, 1.0, 1.0 + width)};
      room.openings[0].hinge_at_from = at_from;
      const auto areas = clearances(room, room.openings[0]);
      const Vec2 hinge(at_from ? 1.0 : 1.0 + width, 0);
      INFO("width " << width << ", hinge " << hinge.x());
      for (int degree = 1; degree < 90; ++degree)
        for (double along : {0.2, 0.5, 0.9, 0.999}) {
          const double a = radians(degree), r = along * width;
          const Vec2 leaf = hinge + r * Vec2(at_from ? std::cos(a) : -std::cos(a), std::sin(a));
          CHECK(covered(areas, leaf));
        }
      // Not more than the approach and the square of the leaf.
      for (const auto& area : areas) CHECK(area.bounds().high.y() <= std::max(0.9, width) + 1e-9);
    }
}

TEST_CASE("Both leaves of a double door are free to swing, and need no more than a leaf's depth") {
  for (double width : {1.2, 1.6, 2.0, 2.6}) {
    Room room = rooms::box(5, 4);
    room.openings = {rooms::door("door-0", 0, 1.0, 1.0 + width)};
    room.openings[0].leaves = 2;
    const auto areas = clearances(room, room.openings[0]);
    for (const bool at_from : {true, false})
      for (int degree = 1; degree < 90; ++degree)
        for (double along : {0.2, 0.5, 0.9, 0.999}) {
          const double a = radians(degree), r = along * 0.5 * width;
          const Vec2 hinge(at_from ? 1.0 : 1.0 + width, 0);
          CHECK(covered(areas, hinge + r * Vec2(at_from ? std::cos(a) : -std::cos(a), std::sin(a))));
        }
    for (const auto& area : areas)
      CHECK(area.bounds().high.y() <= std::max(0.9, 0.5 * width) + 1e-9);
  }
}

TEST_CASE("A sliding door and a window sweep nothing") {
  Room room = rooms::box(4, 4);
  auto sliding = rooms::door("door-0", 0, 1.0, 2.5);
  sliding.swing = DoorSwing::sliding;
  CHECK(clearances(room, sliding).size() == 1);
  CHECK(clearances(room, rooms::window("window-0", 0, 1.0, 2.5)).size() == 1);
}

TEST_CASE("A floor is at most 40,000 square metres of the rectangle round it") {
  CHECK(check(rooms::box(200, 200)));
  CHECK(check(rooms::box(1000, 40)));
  for (const auto& [width, depth] : {std::pair(200.0, 200.01), std::pair(1000.0, 40.01), std::pair(2000.0, 2000.0)}) {
    const auto status = check(rooms::box(width, depth));
    REQUIRE(!status);
    CHECK(status.error().kind == Error::Kind::limit);
    CHECK(status.error().message.find("40000 m2 is the most") != std::string::npos);
  }
  Room room;  // a small floor in a large rectangle
  room.polygon.points = {{0, 0}, {300, 0}, {300, 300}, {299, 300}, {299, 1}, {0, 1}};
  CHECK(!check(room));
}
