#include <nlohmann/json.hpp>

#include "roomgen/scene/plan.h"

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/scene.h"
#include "support/contains.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Plan sample_plan() {
  Plan plan;
  plan.prompt = "a bedroom, no TV";
  plan.seed = 7;
  plan.room = rooms::box(4, 3);
  plan.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  plan.excluded = {"tv"};
  plan.notes = {"the size was chosen"};
  PlanItem bed;
  bed.category = "bed";
  bed.description = "a white bed";
  bed.size = Vec3(1.6, 2.0, 0.9);
  bed.asked = true;
  bed.relations = {{RelationKind::edge, ""}, {RelationKind::far, "door-0"}};
  bed.location = Vec2(2, 1.5);
  PlanItem chair;
  chair.category = "chair";
  chair.quantity = 3;
  chair.varied = true;
  PlanItem lamp;
  lamp.category = "table lamp";
  lamp.mount = Mount::surface;
  lamp.on = "bed";
  plan.items = {bed, chair, lamp, chair};
  return plan;
}

}  // namespace

TEST_CASE("A plan that is written and read has the same bytes when written again") {
  const std::string text = dump_json(to_json(sample_plan()));
  const auto again = plan_from_json(*parse_json(text, "p"), "p");
  REQUIRE(again);
  CHECK(dump_json(to_json(*again)) == text);
  CHECK(again->items[0].relations == sample_plan().items[0].relations);
  CHECK(*again->items[0].location == Vec2(2, 1.5));
  CHECK(again->items[2].on == "bed");
}

TEST_CASE("Ids count over the whole plan, in the order of the items") {
  std::vector<std::string> ids;
  for (const auto& object : planned_objects(sample_plan())) ids.push_back(object.id);
  CHECK(ids == std::vector<std::string>{"bed-0", "chair-0", "chair-1", "chair-2", "table lamp-0",
                                        "chair-3", "chair-4", "chair-5"});
}

TEST_CASE("Each mistake in a plan gives one located line") {
  using Change = void (*)(Json&);
  const std::vector<std::pair<Change, const char*>> cases = {
      {[](Json& j) { j["format"] = "roomgen-scene"; }, "not a plan"},
      {[](Json& j) { j["version"] = 9; }, "/version"},
      {[](Json& j) { j["objects"][0].erase("category"); }, "/objects/0/category"},
      {[](Json& j) { j["objects"][1]["quantity"] = 0; }, "/objects/1/quantity"},
      {[](Json& j) { j["objects"][1]["quantity"] = 1000000; }, "/objects/1/quantity"},
      {[](Json& j) { j["objects"][1]["variance"] = "some"; }, "/objects/1/variance"},
      {[](Json& j) { j["objects"][0]["size"] = {1, 2}; }, "/objects/0/size"},
      {[](Json& j) { j["objects"][0]["constraints"] = "edgy"; }, "did you mean \"edge\"?"},
      {[](Json& j) { j["objects"][0]["locaton"] = {1, 2}; }, "did you mean \"location\"?"},
      {[](Json& j) { j["objects"][0]["location"] = {1, 2, 3}; }, "/objects/0/location"},
      {[](Json& j) { j["room"]["polygon"] = Json::array(); }, "/room/polygon"},
  };
  for (const auto& [change, expected] : cases) {
    Json json = to_json(sample_plan());
    change(json);
    const auto plan = plan_from_json(json, "p.json");
    INFO("expecting " << expected);
    REQUIRE_FALSE(plan);
    INFO(plan.error().message);
    CHECK(is_one_line(plan.error().message));
    CHECK(contains_text(plan.error().message, expected));
  }
}
