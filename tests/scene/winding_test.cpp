// Files may give the corners in either winding; rooms are kept counter-clockwise, and whatever counts walls
// must still mean the wall that its author meant.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/problem.h"
#include "scene/judgement.h"
#include "scene/room_part.h"
#include "support/random_problem.h"

using namespace roomgen;

namespace {

// The same room with its corners the other way round, openings renumbered to the same places.
Room clockwise(const Room& room) {
  Room turned = room;
  const std::size_t n = room.polygon.size();
  std::reverse(turned.polygon.points.begin(), turned.polygon.points.end());
  for (auto& opening : turned.openings) {
    const double length = room.polygon.edge(opening.wall).length();
    opening.wall = (2 * n - 2 - opening.wall) % n;
    const double from = opening.from;
    opening.from = length - opening.to;
    opening.to = length - from;
    opening.hinge_at_from = !opening.hinge_at_from;
  }
  return turned;
}

Vec2 hinge(const Room& room, const Opening& opening) {
  const Segment line = segment(room, opening);
  return opening.hinge_at_from ? line.a : line.b;
}

}  // namespace

TEST_CASE("A room given clockwise has its openings, their insides and their hinges where they were") {
  Random random(1);
  int openings = 0;
  for (int i = 0; i < 100; ++i) {
    const Room room = rooms::random_room(random);
    Scene scene;
    scene.room = clockwise(room);
    REQUIRE(signed_area(scene.room.polygon.points) < 0);
    const auto read = scene_from_json(to_json(scene), "s");
    INFO("room " << i << (read ? "" : read.error().message));
    REQUIRE(read);
    CHECK(area(read->room.polygon) == Approx(area(room.polygon)).margin(1e-3));
    REQUIRE(read->room.openings.size() == room.openings.size());
    for (std::size_t k = 0; k < room.openings.size(); ++k) {
      const Opening &a = room.openings[k], &b = read->room.openings[k];
      ++openings;
      CHECK((segment(room, a).middle() - segment(read->room, b).middle()).norm() < 1e-3);
      CHECK((inward(room, a) - inward(read->room, b)).norm() < 1e-3);
      CHECK(a.width() == Approx(b.width()).margin(1e-3));
      if (a.type == OpeningType::door)
        CHECK((hinge(room, a) - hinge(read->room, b)).norm() < 1e-3);
    }
  }
  CHECK(openings > 50);
}

TEST_CASE("Needless corners in a file do not move its openings") {
  //   3---------2      the bottom wall is given in two pieces, 0-x and x-1
  //   |         |
  //   0----x-D--1
  const auto json = parse_json(R"({"format": "roomgen-scene", "version": 1, "objects": [],
    "room": {"polygon": [[0,0],[2,0],[4,0],[4,3],[0,3]], "openings":
      [{"id": "door-0", "wall": 1, "from": 0.5, "to": 1.4}, {"id": "door-1", "wall": 2, "from": 1, "to": 2}]}})",
                               "s");
  const auto scene = scene_from_json(*json, "s");
  REQUIRE(scene);
  REQUIRE(scene->room.polygon.size() == 4);
  CHECK((segment(scene->room, scene->room.openings[0]).a - Vec2(2.5, 0)).norm() < 1e-9);
  CHECK((segment(scene->room, scene->room.openings[1]).a - Vec2(4, 1)).norm() < 1e-9);
}

namespace {

//  2--(2)--3        corners as the file has them, clockwise from the bottom left; (k) is the file's wall k
//  |       |
// (1)     (3)       the problem's doors and windows are given as segments
//  |       |
//  1--(0)--0
constexpr const char* polygon = "[[4,0],[0,0],[0,3],[4,3]]";

// Where the middle of the wall is that the constraint's target names.
Vec2 middle_of_target(const Room& room, const std::vector<Relation>& relations) {
  REQUIRE(relations.size() == 1);
  const auto part = part_of_room(room, relations[0].target);
  REQUIRE(part);
  return part->center();
}

}  // namespace

TEST_CASE("wall-2 of a problem given clockwise is its author's wall") {
  const auto json = parse_json(std::string(R"({"name": "x", "room": )") + polygon +
                                   R"(, "objects": [{"name": "a-0", "size": [1, 1], "constraints": "near, wall-2"}]})",
                               "p");
  const auto problem = problem_from_json(*json, "p");
  REQUIRE(problem);
  CHECK((middle_of_target(problem->room, problem->tasks[0].object.relations) - Vec2(2, 3)).norm() < 0.01);
}

TEST_CASE("wall-2 of a scene given clockwise is its author's wall") {
  const auto json = parse_json(std::string(R"({"format": "roomgen-scene", "version": 1, "room": {"polygon": )") +
                                   polygon + R"(}, "objects": [{"id": "a-0", "size": [1, 1, 1],
                                   "position": [1, 1, 0], "relations": ["near, wall-2"]}]})",
                               "s");
  const auto scene = scene_from_json(*json, "s");
  REQUIRE(scene);
  CHECK((middle_of_target(scene->room, scene->objects[0].relations) - Vec2(2, 3)).norm() < 0.01);
}

TEST_CASE("wall-2 of a plan given clockwise is its author's wall") {
  const auto json = parse_json(std::string(R"({"format": "roomgen-plan", "version": 1, "room": {"polygon": )") +
                                   polygon +
                                   R"(}, "objects": [{"category": "bed", "constraints": "near, wall-2"}]})",
                               "p");
  const auto plan = plan_from_json(*json, "p");
  REQUIRE(plan);
  CHECK((middle_of_target(plan->room, plan->items[0].relations) - Vec2(2, 3)).norm() < 0.01);
}
