// How many places are tried for one thing: at the limits all, above them fewer (docs/limits.md).
#include "solve/trials.h"

#include <algorithm>
#include <cmath>

#include "solve/layout.h"
#include "solve/place.h"
#include "solve/propose.h"
#include "support/rooms.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

Room regular(int sides, double radius) {
  Room room = rooms::box(1, 1);
  room.polygon.points.clear();
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    room.polygon.points.push_back(Vec2(radius, radius) + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return room;
}

// Each second corner lies further in.
Room star(int corners, double outer, double inner) {
  Room room = regular(corners, outer);
  for (std::size_t i = 1; i < room.polygon.size(); i += 2)
    room.polygon.points[i] = Vec2(outer, outer) + inner / outer * (room.polygon.points[i] - Vec2(outer, outer));
  return room;
}

std::size_t turns_in(const Room& room) {
  const ModelTable models;
  return Layout(room, KindTable::built_in(), models).wall_yaws().size();
}

Problem one_thing(Room room, const std::string& kind, const Vec3& size) {
  Problem problem;
  problem.name = "trials";
  problem.room = std::move(room);
  problem.tasks.push_back({rooms::thing(kind + "-0", kind, size), std::nullopt, std::nullopt});
  return problem;
}

std::vector<Pose> grid_in(const Room& room, double pitch) {
  const ModelTable models;
  const Layout layout(room, KindTable::built_in(), models);
  PlacementTask task;
  task.object = rooms::thing("sofa-0", "sofa", {2.0, 0.9, 0.85});
  task.object.traits.front = true;
  return propose_grid(make_context(layout, task, {}, 1), pitch);
}

}  // namespace

TEST_CASE("Up to 32 turns are all tried, of more a sample of 32 in their order") {
  std::vector<double> turns;
  for (std::size_t i = 0; i < most_turns; ++i) turns.push_back(0.01 * static_cast<double>(i));
  CHECK(thinned(turns) == turns);
  turns.push_back(1.0);
  const auto fewer = thinned(turns);
  CHECK(fewer.size() == most_turns);
  CHECK(std::is_sorted(fewer.begin(), fewer.end()));
  CHECK(std::adjacent_find(fewer.begin(), fewer.end()) == fewer.end());
  // A regular polygon of an odd number of walls has four turns for each.
  CHECK(turns_in(regular(7, 3)) == 28);
  CHECK(turns_in(regular(16, 3)) == 16);
  CHECK(turns_in(regular(9, 3)) == most_turns);
}

TEST_CASE("A grid is as fine as was asked up to its limit, and above it coarser, never larger") {
  const double pitch = 0.2, side = pitch * std::sqrt(most_on_grid / 4);
  CHECK(pitch_within_limit(pitch, rooms::box(0.999 * side, side).polygon, 4) == pitch);
  CHECK(pitch_within_limit(pitch, rooms::box(1.01 * side, side).polygon, 4) > pitch);
  // From 40 walls on each wall counts.
  CHECK(pitch_within_limit(pitch, regular(40, 0.49 * side).polygon, 4) == pitch);
  CHECK(pitch_within_limit(pitch, regular(42, 0.5 * side).polygon, 4) > pitch);
  CHECK(grid_in(rooms::box(10, 10), pitch).size() == 51 * 51 * 4);
  for (const double longer : {0.99, 1.01, 2.0, 15.0}) {
    INFO(longer);
    const auto poses = grid_in(rooms::box(longer * side, side), pitch);
    CHECK(static_cast<double>(poses.size()) < 1.02 * most_on_grid);
    CHECK(static_cast<double>(poses.size()) > 0.9 * std::min(1.0, longer) * most_on_grid);
  }
}

TEST_CASE("Walls are stepped along as finely as was asked up to a length, and above it more coarsely") {
  const double step = 0.1, around = step * most_along_walls;
  CHECK(step_within_limit(step, rooms::box(0.249 * around, 0.249 * around).polygon) == step);
  CHECK(step_within_limit(step, rooms::box(0.3 * around, 0.3 * around).polygon) > step);
}

TEST_CASE("Rounds of improvement are as many as were asked up to a number of walls and turns, and fewer above it") {
  CHECK(rounds_within_limit(300, 16, 32) == 300);
  CHECK(rounds_within_limit(300, 17, 32) == 282);
  CHECK(rounds_within_limit(300, 500, 32) == 9);
  CHECK(rounds_within_limit(12, 500, 32) == 2);
  CHECK(rounds_within_limit(1, 500, 32) == 1);
  CHECK(rounds_within_limit(0, 500, 32) == 0);
}

TEST_CASE("Where nobody gets in by the door, nothing is tried on the floor, and it is said why") {
  Room needle = star(300, 4, 3.5);  // each wall ends in a corner narrower than a person
  needle.openings = {rooms::door("door-0", 0, 0.05, 0.45)};
  auto problem = one_thing(needle, "sofa", {2.0, 0.9, 0.85});
  problem.tasks.push_back({rooms::thing("rug-0", "rug", {1.2, 1.8, 0.01}), std::nullopt, std::nullopt});
  problem.tasks.back().object.traits.flat = true;
  const auto solution = solved(problem);
  REQUIRE(solution.scene.unplaced.size() == 1);
  CHECK(solution.scene.unplaced[0].reason ==
        "no place for sofa-0 (2 x 0.9 x 0.85 m): nobody gets into the room by its doors, even while it is empty; "
        "they need a clear way 0.5 m wide");
  REQUIRE(solution.scene.objects.size() == 1);
  CHECK(solution.scene.objects[0].id == "rug-0");
}

TEST_CASE("A sofa finds its place in a star of as many corners as a room may have") {
  for (const int corners : {60, 300, 500}) {
    INFO(corners);
    const auto solution = solved(one_thing(star(corners, 6, 5), "sofa", {2.0, 0.9, 0.85}));
    CHECK(solution.scene.objects.size() == 1);
    CHECK(violations(solution.scene).empty());
  }
}
