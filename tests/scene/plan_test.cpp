#include <nlohmann/json.hpp>

#include "roomgen/scene/plan.h"

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
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
  lamp.for_each = true;
  lamp.asked = false;
  lamp.spare = 2;
  lamp.tilt = Vec2(radians(-5), radians(90));
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
  CHECK(again->items[2].tilt.isApprox(sample_plan().items[2].tilt));
  CHECK(again->items[2].for_each);
  CHECK(again->items[2].spare == 2);
}

TEST_CASE("What leans stands with its back at a wall, and what dresses is asked for by nobody") {
  Json json = to_json(sample_plan());
  json["dressing"] = {{{"category", "mirror"}, {"lean", 8}}, {{"category", "book"}, {"spare", 3}}};
  const auto plan = plan_from_json(json, "p");
  REQUIRE(plan);
  const PlanItem& mirror = plan->items[4];
  CHECK(mirror.tilt.isApprox(Vec2(radians(-8), 0)));
  CHECK(mirror.relations == std::vector<Relation>{{RelationKind::edge, ""}});
  CHECK(mirror.spare == 1);
  CHECK_FALSE(mirror.asked);
  CHECK(plan->items[5].spare == 3);
}

TEST_CASE("What a plan says and cannot be is told with its place and left open") {
  Json json = to_json(sample_plan());
  json["room"]["light"]["hour"] = 31;
  json["objects"][1]["height"] = 1.2;
  json["objects"][3]["mount"] = "ceiling";
  json["objects"][3]["bottom"] = 9;
  json["objects"][2]["asked"] = true;
  const auto plan = plan_from_json(json, "p");
  REQUIRE(plan);
  CHECK_FALSE(plan->room.light.hour);
  CHECK_FALSE(plan->items[1].height);
  CHECK_FALSE(plan->items[2].asked);
  const auto told = join(plan->notes, "\n");
  for (const char* place : {"/room/light/hour", "/objects/1/height", "/objects/3/bottom", "/objects/2/asked"})
    CHECK(contains_text(told, place));
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
      {[](Json& j) { j["objects"][0]["tilt"] = {200, 0}; }, "/objects/0/tilt"},
      {[](Json& j) { j["objects"][0]["lean"] = -5; }, "/objects/0/lean"},
      {[](Json& j) { j["objects"][0]["mount"] = "wall", j["objects"][0]["lean"] = 5; }, "mount is floor"},
      {[](Json& j) { j["objects"][0]["mount"] = "wall", j["objects"][0]["height"] = -1; }, "/objects/0/height"},
      {[](Json& j) {
         j["objects"][0]["mount"] = "wall";
         j["objects"][0]["height"] = j["objects"][0]["bottom"] = 1;
       },
       "either \"height\""},
      {[](Json& j) { j["objects"][1]["per"] = "each"; }, "needs \"on\""},
      {[](Json& j) { j["objects"][1]["per"] = "every"; }, "must be \"all\" or \"each\""},
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
