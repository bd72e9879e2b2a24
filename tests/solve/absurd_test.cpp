#include "support/brute_force.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

Problem problem_of(Room room, int count, const std::string& category, const Vec3& size) {
  Problem problem;
  problem.name = "absurd";
  problem.room = std::move(room);
  for (int i = 0; i < count; ++i)
    problem.tasks.push_back(
        {rooms::thing(category + "-" + std::to_string(i), category, size), std::nullopt, std::nullopt});
  return problem;
}

}  // namespace

TEST_CASE("Of a hundred sofas a room takes what it holds and says why not the others") {
  Room room = rooms::box(5, 4);
  room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  const auto problem = problem_of(room, 100, "sofa", {2.0, 0.9, 0.85});
  const auto solution = solved(problem, 0, 2);
  CHECK(solution.scene.objects.size() >= 3);
  CHECK(solution.scene.objects.size() < 11);  // 20 m2 hold eleven without a place to stand
  CHECK(solution.scene.objects.size() + solution.scene.unplaced.size() == 100);
  for (const auto& missing : solution.scene.unplaced)
    CHECK(missing.reason.find("no place for " + missing.id) == 0);
  CHECK(violations(solution.scene).empty());
  CHECK(brute_force::faults(solution.scene).empty());
}

TEST_CASE("A room of one square metre takes a plant and no bed") {
  Room room = rooms::box(1, 1);
  room.openings = {rooms::door("door-0", 0, 0.1, 0.9)};
  room.openings[0].swing = DoorSwing::out;
  auto problem = problem_of(room, 1, "bed", {1.6, 2.0, 0.5});
  problem.tasks.push_back({rooms::thing("plant-0", "plant", {0.2, 0.2, 0.5}), std::nullopt, std::nullopt});
  const auto solution = solved(problem);
  REQUIRE(solution.scene.objects.size() == 1);
  CHECK(solution.scene.objects[0].id == "plant-0");
  REQUIRE(solution.scene.unplaced.size() == 1);
  CHECK(solution.scene.unplaced[0].id == "bed-0");
  CHECK(violations(solution.scene).empty());
}

TEST_CASE("A room smaller than a person, without a door, ends too") {
  const auto solution = solved(problem_of(rooms::box(0.3, 0.3), 3, "chair", {0.5, 0.5, 0.9}));
  CHECK(solution.scene.objects.empty());
  CHECK(solution.scene.unplaced.size() == 3);
}

TEST_CASE("Nothing to place is placed") {
  const auto solution = solved(problem_of(rooms::box(4, 4), 0, "", {1, 1, 1}));
  CHECK(solution.scene.objects.empty());
  CHECK(solution.constraints == 0);
}

TEST_CASE("A suggestion far outside the room is no reason to stay out") {
  auto problem = problem_of(rooms::box(4, 4), 1, "plant", {0.4, 0.4, 0.9});
  problem.tasks[0].location = Vec2(900, -900);
  const auto solution = solved(problem);
  REQUIRE(solution.scene.objects.size() == 1);
  // The corner that is nearest.
  CHECK((solution.scene.objects[0].position.head<2>() - Vec2(4, 0)).norm() < 0.8);
}

TEST_CASE("A free suggestion is followed to the centimetre") {
  auto problem = problem_of(rooms::box(4, 4), 1, "plant", {0.4, 0.4, 0.9});
  problem.tasks[0].location = Vec2(1.234, 2.345);
  const auto solution = solved(problem);
  REQUIRE(solution.scene.objects.size() == 1);
  CHECK((solution.scene.objects[0].position.head<2>() - Vec2(1.234, 2.345)).norm() < 0.01);
}

TEST_CASE("A circle of constraints is an error that names its members") {
  auto problem = problem_of(rooms::box(4, 4), 2, "plant", {0.4, 0.4, 0.9});
  problem.tasks[0].object.relations = {{RelationKind::near, "plant-1"}};
  problem.tasks[1].object.relations = {{RelationKind::near, "plant-0"}};
  const auto solution = solve(problem, ModelTable(), KindTable::built_in());
  REQUIRE_FALSE(solution);
  CHECK(solution.error().kind == Error::Kind::invalid_input);
  CHECK(solution.error().message.find("\"plant-0\", \"plant-1\"") != std::string::npos);
}
