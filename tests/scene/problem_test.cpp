#include "roomgen/scene/problem.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "support/contains.h"
#include "support/rooms.h"
#include "support/shapes.h"

using namespace roomgen;

namespace {

Json sample_problem() {
  return *parse_json(R"({"name": "x", "room_type": "bedroom", "room": [[0,0],[4,0],[4,3],[0,3]],
    "doors": [{"segment": [[1.4,0],[0.5,0]]}], "windows": [{"segment": [[1,3],[2,3]]}],
    "objects": [{"name": "Office Chair-0", "size": [0.5, 0.6], "location": [1, 2], "facing": 90},
                {"name": "bed-0", "size": [1.6, 2, 0.5], "constraints": "edge | far, door-0"}]})",
                     "p");
}

std::vector<PlacementTask> tasks(const std::vector<std::pair<std::string, std::vector<std::string>>>& list) {
  std::vector<PlacementTask> result;
  for (const auto& [id, targets] : list) {
    PlacementTask task;
    task.object.id = id;
    for (const auto& target : targets) task.object.relations.push_back({RelationKind::near, target});
    result.push_back(task);
  }
  return result;
}

}  // namespace

TEST_CASE("A problem is read with the documented defaults") {
  const auto problem = problem_from_json(sample_problem(), "p");
  REQUIRE(problem);
  REQUIRE(problem->tasks.size() == 2);
  const auto& chair = problem->tasks[0];
  CHECK(chair.object.id == "office chair-0");
  CHECK(chair.object.category == "office chair");
  CHECK(chair.object.size == Vec3(0.5, 0.6, 0.9));
  CHECK(*chair.location == Vec2(1, 2));
  CHECK(*chair.facing == Approx(pi / 2));
  CHECK(problem->tasks[1].object.size.z() == 0.5);
  REQUIRE(problem->room.openings.size() == 2);
  const auto& door = problem->room.openings[0];
  CHECK(door.id == "door-0");
  CHECK(door.swing == DoorSwing::in);
  CHECK((segment(problem->room, door).a - Vec2(0.5, 0)).norm() < 1e-9);
  CHECK_FALSE(door.hinge_at_from);  // hinged at its first point, which is the far one
  CHECK(problem->room.openings[1].sill == 0.9);
}

TEST_CASE("Every published problem and known room is sound") {
  int count = 0;
  for (const char* folder : {"rooms", "solver-scenes"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(ROOMGEN_TEST_DATA) / folder)) {
      if (entry.path().extension() != ".json") continue;
      const auto problem = read_problem(entry.path());
      INFO(entry.path().filename());
      CHECK(problem);
      ++count;
    }
  CHECK(count >= 73);
}

TEST_CASE("Each mistake in a problem gives one located line") {
  using Change = void (*)(Json&);
  const std::vector<std::pair<Change, const char*>> cases = {
      {[](Json& j) { j["units"] = "ft"; }, "/units"},
      {[](Json& j) { j["rom"] = 1; }, "did you mean \"room\"?"},
      {[](Json& j) { j["room"] = {{0, 0}, {4, 0}, {0, 4}, {5, 6}}; }, "/room: polygon"},
      {[](Json& j) { j["doors"][0]["segment"] = {{1, 1}, {2, 1}}; }, "/doors/0/segment: lies on no wall"},
      {[](Json& j) { j["doors"][0]["segment"] = {{1, 0}}; }, "/doors/0/segment"},
      {[](Json& j) { j["doors"][0]["swing"] = "up"; }, "/doors/0/swing"},
      {[](Json& j) { j["windows"][0]["sill"] = 2.5; }, "window-0"},
      {[](Json& j) { j["windows"][0]["segment"] = {{0.6, 0}, {1, 0}}, j["windows"][0]["sill"] = 0; },
       "overlaps"},
      {[](Json& j) { j["objects"][0]["size"] = {0.5}; }, "/objects/0/size"},
      {[](Json& j) { j["objects"][0]["size"] = {0.5, -1}; }, "/objects/0/size/1"},
      {[](Json& j) { j["objects"][0].erase("name"); }, "/objects/0/name"},
      {[](Json& j) { j["objects"][1]["name"] = "office chair-0"; }, "two objects named"},
      {[](Json& j) { j["objects"][1]["constraints"] = "edge | near, bad"; }, "\"bad\""},
      {[](Json& j) { j["objects"][1]["constraints"] = "near, wall-4"; }, "wall-4"},
      {[](Json& j) { j["objects"][1]["constraints"] = "near, bed-0"; }, "bed-0"},
      {[](Json& j) { j["objects"][1]["constraint"] = "edge"; }, "did you mean \"constraints\"?"},
      {[](Json& j) { j["objects"][1]["facing"] = true; }, "/objects/1/facing"},
      // Not in the format: nobody shall believe that they do something.
      {[](Json& j) { j["objects"][1]["mount"] = "wall"; }, "/objects/1: unknown key \"mount\""},
      {[](Json& j) { j["objects"][1]["on"] = "bed-0"; }, "/objects/1: unknown key \"on\""},
      {[](Json& j) { j["objects"][1]["traits"] = {"round"}; }, "/objects/1: unknown key \"traits\""},
  };
  for (const auto& [change, expected] : cases) {
    Json json = sample_problem();
    change(json);
    const auto problem = problem_from_json(json, "p.json");
    INFO("expecting " << expected);
    REQUIRE_FALSE(problem);
    INFO(problem.error().message);
    CHECK(is_one_line(problem.error().message));
    CHECK(contains_text(problem.error().message, "p.json: "));
    CHECK(contains_text(problem.error().message, expected));
  }
}

TEST_CASE("Objects come after those that their constraints name, otherwise in the file's order") {
  const auto order = placement_order(
      tasks({{"a", {"c"}}, {"b", {"door-0"}}, {"c", {"d"}}, {"d", {}}, {"e", {}}}));
  REQUIRE(order);
  CHECK(*order == std::vector<std::size_t>{1, 3, 2, 0, 4});
}

TEST_CASE("In a random order without circles, every object comes after its targets") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    std::vector<std::pair<std::string, std::vector<std::string>>> list;
    const int count = random.integer(1, 15);
    for (int k = 0; k < count; ++k) {
      std::vector<std::string> targets;
      if (k > 0)
        for (int n = random.integer(0, 2); n > 0; --n)
          targets.push_back("t-" + std::to_string(random.integer(0, k - 1)));
      list.push_back({"t-" + std::to_string(k), targets});
    }
    random.shuffle(list);
    const auto order = placement_order(tasks(list));
    REQUIRE(order);
    std::vector<std::string> placed;
    for (std::size_t k : *order) {
      for (const auto& target : list[k].second)
        REQUIRE(std::find(placed.begin(), placed.end(), target) != placed.end());
      placed.push_back(list[k].first);
    }
    REQUIRE(placed.size() == list.size());
  }
}

TEST_CASE("A circle is an error that names those in it and not those outside") {
  const auto order = placement_order(
      tasks({{"free-0", {}}, {"a-0", {"b-0"}}, {"b-0", {"c-0"}}, {"c-0", {"a-0"}}, {"last-0", {"free-0"}}}));
  REQUIRE_FALSE(order);
  CHECK(contains_text(order.error().message, "\"a-0\", \"b-0\", \"c-0\""));
  CHECK(contains_text(order.error().message, "circle"));
  CHECK_FALSE(contains_text(order.error().message, "free-0"));
  CHECK_FALSE(contains_text(order.error().message, "last-0"));
}

TEST_CASE("What an object stands on comes before it") {
  auto list = tasks({{"lamp-0", {}}, {"table-0", {}}});
  list[0].object.on = "table-0";
  CHECK(*placement_order(list) == std::vector<std::size_t>{1, 0});
}
