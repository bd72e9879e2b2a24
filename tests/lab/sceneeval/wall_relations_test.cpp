#include "catch.h"
#include "lab/sceneeval/geometric_relations.h"
#include "roomgen/lab/scores.h"
#include "support/rooms.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

// In a room of five by four; the back of what has yaw 0 looks north.
const std::vector<Thing>& four_walls() {
  static const RoomThings parts = room_things(rooms::box(5, 4));
  return parts.walls;
}

Thing placed_at(const Vec3& size, const Vec3& at, double yaw = 0.0) {
  Object object = rooms::thing("a-0", "thing", size, at.head<2>(), yaw);
  object.position.z() = at.z();
  return thing_of(object, ModelTable());
}

}  // namespace

TEST_CASE("A clock hangs on the wall behind a bench, high up") {
  const Vec3 clock(0.3, 0.1, 0.3);
  const Thing bench = placed_at({1.4, 0.4, 0.45}, {2, 3.8, 0});
  const auto behind = [&](const Vec3& at, double yaw = 0.0) {
    return behind_on_wall(placed_at(clock, at, yaw), bench, four_walls());
  };
  CHECK(behind({2.2, 3.95, 1.7}) == 1.0);
  CHECK(behind({3.1, 3.95, 1.7}) == 0.0);     // beside it
  CHECK(behind({2, 0.05, 1.7}, 180) == 0.0);  // before it
  CHECK(behind({2.2, 3.7, 1.7}) == 0.0);      // on no wall
  CHECK(behind_on_wall(placed_at({0.3, 0.1, 1.8}, {2.2, 3.95, 0}), bench, four_walls()) ==
        0.0);  // stands
  const Thing sofa = placed_at({1.4, 0.9, 0.8}, {2, 2, 0});
  CHECK(behind_on_wall(placed_at(clock, {2.2, 3.95, 1.7}), sofa, four_walls()) == 1.0);
}

TEST_CASE("What is under or above a mirror may be deeper than it") {
  const Thing mirror = placed_at({1.2, 0.04, 0.8}, {2, 3.98, 1.0});
  const auto under = [&](const Vec3& size, const Vec3& at) {
    return under_sheet(placed_at(size, at), mirror, four_walls());
  };
  CHECK(under({0.3, 0.3, 0.8}, {2.3, 3.85, 0}) == 1.0);
  CHECK(under({2.4, 0.4, 0.8}, {2.9, 3.8, 0}) == 1.0);    // wider than the mirror
  CHECK(under({0.3, 0.3, 0.8}, {2.8, 3.85, 0}) == 0.0);   // beside it
  CHECK(under({0.3, 0.3, 0.8}, {2.3, 3.0, 0}) == 0.0);    // out in the room
  CHECK(under({0.3, 0.3, 1.8}, {2.3, 3.7, 0.2}) == 0.0);  // before it
  const auto above = [&](const Vec3& at) {
    return above_sheet(placed_at({0.2, 0.2, 0.2}, at), mirror, four_walls());
  };
  CHECK(above({2.1, 3.9, 1.9}) == 1.0);
  CHECK(above({2.1, 3.9, 0.5}) == 0.0);
  const Thing cupboard = placed_at({1.2, 0.35, 0.8}, {2, 3.82, 1.0});
  CHECK(under_sheet(placed_at({0.3, 0.3, 0.8}, {2.3, 3.85, 0}), cupboard, four_walls()) == 0.0);
  const Thing leaning = placed_at({1.2, 0.04, 0.8}, {2, 3.98, 0});
  CHECK(above_sheet(placed_at({0.2, 0.2, 0.2}, {2.1, 3.9, 0.9}), leaning, four_walls()) == 0.0);
}

TEST_CASE("Rows may ask what hangs behind and stands under") {
  const auto rows = parse_requirements(
      "ID,Description,ObjCount,OORel\n1,x,\"eq,1,bench\","
      "\"eq,1,behind,0,bench,clock;eq,1,behind,0,clock,bench;"
      "eq,1,under,0,mirror,plant;eq,1,above,0,mirror,plant\"\n",
      "r");
  REQUIRE(rows);
  Scene scene = rooms::scene(rooms::box(5, 4),
                             {rooms::thing("bench-0", "bench", {1.4, 0.4, 0.45}, {2, 3.8}),
                              rooms::thing("clock-0", "clock", {0.3, 0.1, 0.3}, {2, 3.95}),
                              rooms::thing("mirror-0", "mirror", {1.2, 0.04, 0.8}, {4, 3.98}),
                              rooms::thing("plant-0", "plant", {0.3, 0.3, 0.8}, {4, 3.85})});
  scene.objects[1].position.z() = 1.7;
  scene.objects[2].position.z() = 1.0;
  const auto verdicts = score_room(rows->front(), scene, ModelTable()).object_relations;
  std::vector<bool> held;
  for (const auto& verdict : verdicts) held.push_back(verdict.satisfied);
  CHECK(held == std::vector<bool>{true, false, true, false});
}
