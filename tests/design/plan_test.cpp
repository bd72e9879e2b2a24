#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "brief/room_kinds.h"
#include "catch.h"
#include "plans.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;
using roomgen::test::count_of;
using roomgen::test::plan_of;

namespace {

struct Floor {
  int things = 0;
  double share = 0.0;
};

Floor floor_of(const Plan& plan) {
  Floor floor;
  for (const auto& item : plan.items) {
    if (item.mount != Mount::floor) continue;
    floor.things += item.quantity;
    if (!KindTable::built_in().get(item.category).traits.flat)
      floor.share += item.quantity * item.size->x() * item.size->y();
  }
  floor.share /= area(plan.room.polygon);
  return floor;
}

// The targets of fixed relations come earlier in the plan or are parts of the room.
bool targets_are_placed_before(const Plan& plan) {
  std::set<std::string> known{"corner"};
  for (const auto& opening : plan.room.openings) known.insert(opening.id);
  for (std::size_t k = 0; k < plan.room.polygon.size(); ++k)
    known.insert("wall-" + std::to_string(k));
  for (const auto& planned : planned_objects(plan)) {
    for (const auto& relation : plan.items[planned.item].relations)
      if (!relation.target.empty() && !known.count(relation.target)) return false;
    known.insert(planned.id);
  }
  return true;
}

Result<Plan> try_plan(const std::string& prompt, std::optional<Vec2> size = std::nullopt) {
  PlanRequest request;
  request.prompt = prompt;
  request.size = size;
  return make_rule_designer()->plan(request);
}

}  // namespace

TEST_CASE("rooms of the six kinds are sound, full enough and not too full") {
  for (const char* type : test::room_types)
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      INFO(type << ", seed " << seed);
      const Plan plan = plan_of(type, seed);
      const Floor floor = floor_of(plan);
      CHECK(check(plan.room).ok());
      CHECK(plan.room.type == type);
      CHECK(find_opening(plan.room, "door-0") != nullptr);
      CHECK(floor.things >= 8);
      CHECK(planned_objects(plan).size() <= 45);
      CHECK(floor.share > 0.1);
      CHECK(floor.share < 0.5);
      CHECK(area(plan.room.polygon) <= 100.0 + 1e-6);
      CHECK(targets_are_placed_before(plan));
    }
}

TEST_CASE("rooms of all kinds are sound and hold enough") {
  for (const auto& [type, kind] : brief::built_in_room_kinds()->types)
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      INFO(type << ", seed " << seed);
      const Plan plan = plan_of("a " + type, seed);
      const Floor floor = floor_of(plan);
      CHECK(check(plan.room).ok());
      CHECK(plan.room.type == type);
      CHECK(floor.things >= std::min(8, kind.objects_low));
      CHECK(floor.share < 0.55);
      CHECK(targets_are_placed_before(plan));
      for (const auto& category : kind.known_by.value_or(std::vector<std::string>{}))
        CHECK(KindTable::built_in().all().count(category) == 1);
    }
}

TEST_CASE("what comes along for each comes as often as there are such things") {
  CHECK(count_of(plan_of("a cafe with four bistro tables"), "chair") == 8);
  CHECK(count_of(plan_of("a barber shop with three styling stations"), "barber chair") == 3);
  // Neighbours share.
  CHECK(count_of(plan_of("a bedroom with a double bed"), "nightstand") == 2);
  CHECK(count_of(plan_of("a bedroom with two single beds"), "nightstand") == 2);
}

TEST_CASE("what makes a room of its kind is always there") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    CHECK(count_of(plan_of("bedroom", seed), "bed") >= 1);
    CHECK(count_of(plan_of("living room", seed), "sofa") >= 1);
    const Plan kitchen = plan_of("kitchen", seed);
    CHECK(count_of(kitchen, "stove") == 1);
    CHECK(count_of(kitchen, "kitchen sink") == 1);
    CHECK(count_of(kitchen, "refrigerator") == 1);
    const Plan bathroom = plan_of("bathroom", seed);
    CHECK(count_of(bathroom, "toilet") == 1);
    CHECK(count_of(bathroom, "washbasin") == 1);
    const Plan dining_room = plan_of("dining room", seed);
    CHECK(count_of(dining_room, "dining table") == 1);
    CHECK(count_of(dining_room, "dining chair") >= 4);
    CHECK(count_of(plan_of("balcony", seed), "plant") >= 2);
  }
}

TEST_CASE("the same seed gives the same plan, another seed another one") {
  for (const char* type : test::room_types) {
    const auto bytes = [&](std::uint64_t seed) { return dump_json(to_json(plan_of(type, seed))); };
    CHECK(bytes(7) == bytes(7));
    std::set<std::string> different;
    for (std::uint64_t seed = 0; seed < 20; ++seed) different.insert(bytes(seed));
    CHECK(different.size() == 20);
  }
}

TEST_CASE("a plan survives its file") {
  const Plan plan = plan_of("a bedroom with a desk by the window, no rug", 3);
  const Json json = to_json(plan);
  const auto again = plan_from_json(json, "plan.json");
  REQUIRE(again.ok());
  CHECK(dump_json(to_json(*again)) == dump_json(json));
}

TEST_CASE("what the prompt asks for is in the plan as often as asked") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Plan plan = plan_of("a living room with two sofas, three armchairs and a piano", seed);
    CHECK(count_of(plan, "sofa") == 2);
    CHECK(count_of(plan, "armchair") == 3);
    CHECK(count_of(plan, "piano") == 1);
  }
}

TEST_CASE("what the prompt forbids is not in the plan") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Plan plan = plan_of("a living room without chairs, no tv and no plants", seed);
    CHECK(count_of(plan, "tv") == 0);
    CHECK(count_of(plan, "tv stand") == 0);
    CHECK(count_of(plan, "plant") == 0);
    CHECK(count_of(plan, "chair") == 0);
  }
  const Plan bare = plan_of("a bedroom with only a bed and a chair");
  CHECK(planned_objects(bare).size() == 2);
}

TEST_CASE("the size of the room is the one that is asked for") {
  const auto box = [](const Plan& plan) -> Vec2 { return bounds(plan.room.polygon).size(); };
  CHECK(box(plan_of("a 4x5 m bedroom")).isApprox(Vec2(4, 5)));
  CHECK(area(plan_of("a bedroom of 15 square metres").room.polygon) == Approx(15).margin(0.1));
  CHECK(box(*try_plan("a 4x5 m bedroom", Vec2(3, 3))).isApprox(Vec2(3, 3)));
}

TEST_CASE("placements of the prompt become relations between ids") {
  const Plan plan = plan_of("a bedroom with a desk by the window and a lamp on the desk");
  const auto relations = [&](const std::string& category) {
    for (const auto& item : plan.items)
      if (item.asked && item.category == category) return to_text(item.relations);
    return std::string("none");
  };
  CHECK(relations("desk") == "near, window-0");
  CHECK(relations("table lamp").empty() == false);
  CHECK(relations("desk lamp") + relations("table lamp") == "noneon, desk-0");
}

TEST_CASE("people decide how many seats there are") {
  const Plan plan = plan_of("a dining room for eight");
  CHECK(count_of(plan, "chair") == 8);
  for (const auto& item : plan.items)
    if (KindTable::built_in().is_a(item.category, "dining table"))
      CHECK(std::max(item.size->x(), item.size->y()) >= 1.5);
}

TEST_CASE("an unknown kind of room holds what the prompt names, else a seat and a table") {
  const Plan boat_house = plan_of("a boat house");
  CHECK(boat_house.room.type == "boat house");
  CHECK(count_of(boat_house, "table") >= 1);
  CHECK(count_of(boat_house, "seat") >= 1);
  const Plan brewery = plan_of("a brewery with six small round tables");
  CHECK(count_of(brewery, "bistro table") == 6);
}

TEST_CASE("a prompt that is empty, absurd or endless is an error") {
  CHECK_FALSE(try_plan("").ok());
  CHECK_FALSE(try_plan(" \n\t ").ok());
  CHECK_FALSE(try_plan("asdf qwer").ok());
  CHECK_FALSE(try_plan(std::string(max_prompt_bytes + 1, 'a')).ok());
}

TEST_CASE("bounds on size are errors, small rooms hold little") {
  CHECK_FALSE(try_plan("bedroom", Vec2(0.1, 3)).ok());
  CHECK_FALSE(try_plan("bedroom", Vec2(3, 1000)).ok());
  for (const char* type : test::room_types) {
    const auto plan = try_plan(type, Vec2(1, 1));
    INFO(type);
    if (!plan) {
      CHECK(plan.error().message.find("cannot be one") != std::string::npos);
      continue;
    }
    CHECK(check(plan->room).ok());
    CHECK(floor_of(*plan).things <= 4);
  }
}

TEST_CASE("a hundred sofas stay a hundred") {
  const Plan plan = plan_of("a living room with 100 sofas");
  CHECK(count_of(plan, "sofa") == 100);
}

TEST_CASE("a floor plan that is given is kept, and gets a door if it has none") {
  PlanRequest request;
  request.prompt = "a living room";
  Room room;
  room.polygon.points = {{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 5}, {0, 5}};
  request.room = room;
  const auto plan = make_rule_designer()->plan(request);
  REQUIRE(plan.ok());
  CHECK(plan->room.polygon.points == room.polygon.points);
  CHECK(plan->room.openings.size() == 1);
  CHECK(check(plan->room).ok());
}

TEST_CASE("things in rows have their places, all inside the room and clear of each other") {
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const char* prompt : {"eighteen chairs in three rows of six facing a lectern",
                               "a classroom with twelve desks in rows of four",
                               "nine plinths in a 3 by 3 grid"}) {
      const Plan plan = plan_of(prompt, seed);
      const auto placed = test::in_block(plan);
      INFO(prompt << ", seed " << seed);
      REQUIRE(placed.size() >= 9);
      REQUIRE(plan.groups.front().location);
      std::vector<double> lines[2];
      for (std::size_t i = 0; i < placed.size(); ++i) {
        CHECK(contains(plan.room.polygon, placed[i]));
        for (int axis : {0, 1}) {
          const double at = placed[i].center()[axis];
          const auto is_known = [&](double line) { return std::abs(line - at) < 0.01; };
          if (std::none_of(lines[axis].begin(), lines[axis].end(), is_known)) lines[axis].push_back(at);
        }
        for (std::size_t j = 0; j < i; ++j) CHECK(gap(placed[i], placed[j]) > 0.0);
      }
      CHECK(lines[0].size() * lines[1].size() == placed.size());
    }
}

TEST_CASE("islands are of as many as were said, pushed together and apart from each other") {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Plan plan = plan_of("a primary classroom with desks for 16 pupils pushed together in islands of four", seed);
    INFO("seed " << seed);
    const auto desks = test::in_block(plan);
    REQUIRE(desks.size() == 16);
    for (const auto& desk : desks) {
      const auto together = std::count_if(desks.begin(), desks.end(), [&](const Footprint& other) { return gap(desk, other) < 0.02; });
      CHECK(together >= 3);  // with itself
      CHECK(together <= 4);
    }
  }
}

TEST_CASE("words of light set the light of the room, and those of things or denied do not") {
  const auto light_of = [](const std::string& prompt) { return plan_of(prompt, 1).room.light; };
  const Lighting candles = light_of("a candlelit dining room");
  CHECK(candles.sky == Sky::night);
  CHECK(candles.kelvin == 1900.0);
  CHECK(candles.lux == 30.0);
  const Lighting evening = light_of("a moody living room for rainy evenings");
  CHECK(evening.hour == 20.5);
  CHECK(evening.sky == Sky::overcast);
  CHECK(evening.lux == 30.0);
  const Lighting morning = light_of("a bedroom on a bright morning");
  CHECK(morning.hour == 8.5);
  CHECK(morning.lux == 500.0);
  for (const char* prompt : {"a bedroom with a bright yellow armchair", "a study that is not too bright", "a bedroom"})
    CHECK(light_of(prompt) == Lighting());
}

TEST_CASE("What a picture shows and a sign says is part of how it is described") {
  const Plan plan = test::plan_of(
      "A bar with a neon sign that says \"JAZZ\" above the counter, a poster of a whale and a "
      "Japanese painting with a crane, and a plain picture near the fish tank.");
  const auto describes = [&](const std::string& text) {
    return std::any_of(plan.items.begin(), plan.items.end(),
                       [&](const PlanItem& item) { return item.description == text; });
  };
  CHECK(describes("\"jazz\" neon sign"));
  CHECK(describes("whale poster"));
  CHECK(describes("crane japanese painting"));
  CHECK(describes("plain picture"));
}
