#include "solve/improve.h"
#include "solve/place.h"
#include "solve/quality.h"

#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

// A layout made of the first pass alone, with what it left out.
struct Started {
  std::vector<PlacementTask> tasks;
  std::map<std::string, std::string> reasons;
};

Started start(Layout& layout, const Problem& problem, Random& random) {
  Started started;
  const auto order = placement_order(problem.tasks);
  REQUIRE(order);
  for (std::size_t i : *order) started.tasks.push_back(problem.tasks[i]);
  for (const auto& task : started.tasks) {
    const auto placed = place(layout, task, {}, {}, random);
    if (placed) layout.add(placed->object);
    else started.reasons[task.object.id] = placed.error().message;
  }
  return started;
}

}  // namespace

TEST_CASE("Locked objects never move, whatever else is improved around them") {
  int locked_objects = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Problem problem = rooms::random_problem(300 + seed);
    Random random(seed);
    for (auto& task : problem.tasks) task.object.locked = random.chance(0.4);
    const ModelTable models;
    Layout layout(problem.room, KindTable::built_in(), models);
    auto started = start(layout, problem, random);
    std::vector<Object> before;
    for (const auto& object : layout.objects())
      if (object.locked) before.push_back(object);
    ImproveOptions options;
    options.rounds = 12;
    improve(layout, started.tasks, started.reasons, options, random);
    for (const auto& object : before) {
      ++locked_objects;
      const Object* after = layout.find(object.id);
      INFO("problem " << 300 + seed << ", " << object.id);
      REQUIRE(after);
      CHECK(after->position == object.position);
      CHECK(after->yaw == object.yaw);
    }
  }
  CHECK(locked_objects > 5);
}

TEST_CASE("Improvement never makes a layout worse and keeps it valid") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Problem problem = rooms::random_problem(400 + seed);
    Random random(seed);
    const ModelTable models;
    Layout layout(problem.room, KindTable::built_in(), models);
    auto started = start(layout, problem, random);
    const auto before = quality(layout, started.tasks);
    ImproveOptions options;
    options.rounds = 12;
    improve(layout, started.tasks, started.reasons, options, random);
    INFO("problem " << 400 + seed);
    CHECK_FALSE(before.better_than(quality(layout, started.tasks)));
    CHECK(violations(rooms::scene(problem.room, {layout.objects().begin(), layout.objects().end()}))
              .empty());
    // A reason for each that is left out, and for no other.
    for (const auto& task : started.tasks)
      CHECK((layout.find(task.object.id) != nullptr) != (started.reasons.count(task.object.id) == 1));
  }
}

TEST_CASE("A thing that stands in another's only place is moved out of it") {
  //  +----------+   The wardrobe fits nowhere but where the plant stands: the other walls are too short
  //  |P         |   or belong to the door.
  //  +-door-----+
  Problem problem;
  problem.room = rooms::box(3.0, 1.7);
  problem.room.openings = {rooms::door("door-0", 0, 0.3, 1.2)};
  problem.tasks = {{rooms::thing("plant-0", "plant", {0.4, 0.4, 0.9}), std::nullopt, std::nullopt},
                   {rooms::thing("wardrobe-0", "wardrobe", {2.4, 0.6, 2.0}), std::nullopt, std::nullopt}};
  problem.tasks[1].object.relations = {{RelationKind::edge, ""}};
  const ModelTable models;
  Layout layout(problem.room, KindTable::built_in(), models);
  Object plant = problem.tasks[0].object;
  plant.position = {1.5, 1.4, 0};
  layout.add(plant);
  std::map<std::string, std::string> reasons = {{"wardrobe-0", "no place"}};
  Random random(1);
  improve(layout, problem.tasks, reasons, {}, random);
  REQUIRE(layout.find("wardrobe-0"));
  REQUIRE(layout.find("plant-0"));
  CHECK(reasons.empty());
}

TEST_CASE("A layout that holds everything is left alone") {
  Problem problem;
  problem.room = rooms::box(4, 4);
  problem.tasks = {{rooms::thing("plant-0", "plant", {0.4, 0.4, 0.9}), std::nullopt, std::nullopt}};
  const ModelTable models;
  Layout layout(problem.room, KindTable::built_in(), models);
  Random random(1);
  auto started = start(layout, problem, random);
  const Object before = *layout.find("plant-0");
  CHECK(improve(layout, started.tasks, started.reasons, {}, random) == 0);
  CHECK(moved_by(before, *layout.find("plant-0")) == 0.0);
}
