#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/design/designer.h"
#include "support/contains.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Plan plan_wanting(std::vector<WantedOpening> openings) {
  Plan plan;
  plan.room = rooms::box(5, 4);
  plan.room.type = "living room";
  plan.openings = std::move(openings);
  return plan;
}

WantedOpening wanted(const std::string& kind, const std::string& wall) {
  WantedOpening opening;
  opening.kind = kind;
  opening.wall = wall;
  return opening;
}

Plan settled(Plan plan) {
  settle(plan);
  CHECK(plan.openings.empty());
  CHECK(check(plan.room));
  return plan;
}

}  // namespace

TEST_CASE("openings come to the place that is said, and the others find one") {
  WantedOpening french = wanted("french door", "south");
  french.at = 0.25;
  french.width = 1.6;
  french.purpose = "to the garden";
  WantedOpening porthole = wanted("round window", "wall-1");
  porthole.offset = -1.0;
  porthole.sill = 1.3;
  porthole.head = 2.1;
  const Plan plan = settled(plan_wanting({french, porthole, wanted("window", "north"), wanted("door", "")}));
  CHECK(plan.notes.empty());
  REQUIRE(plan.room.openings.size() == 4);
  const Opening& garden = plan.room.openings[0];
  CHECK(garden.wall == 0);
  CHECK(0.5 * (garden.from + garden.to) == Approx(1.25));
  CHECK(garden.width() == Approx(1.6));
  CHECK(garden.kind == "french door");
  CHECK(garden.purpose == "to the garden");
  const Opening& round = plan.room.openings[1];
  CHECK(round.wall == 1);
  CHECK(0.5 * (round.from + round.to) == Approx(1.0));
  CHECK(round.sill == 1.3);
  CHECK(round.head == 2.1);
  int in_north = 0;
  for (const auto& opening : plan.room.openings) in_north += opening.wall == 2 && opening.type == OpeningType::window;
  CHECK(in_north == 1);
}

TEST_CASE("openings that overlap or lie outside are told with their place, and the others are made") {
  WantedOpening first = wanted("door", "south"), second = first, outside = wanted("window", "east"), high = outside;
  first.at = second.at = 0.5;
  outside.at = 0.99;
  high.at = 0.5;
  high.head = 5.0;
  const Plan plan = settled(plan_wanting({first, second, outside, high, wanted("window", "west")}));
  CHECK(plan.room.openings.size() == 2);
  REQUIRE(plan.notes.size() == 3);
  CHECK(contains_text(plan.notes[0], "/openings/1"));
  CHECK(contains_text(plan.notes[1], "/openings/2"));
  CHECK(contains_text(plan.notes[2], "/openings/3"));
}

TEST_CASE("style and palette dress what nobody described") {
  Plan plan = plan_wanting({});
  plan.room.palette = {{"main", "sage"}, {"wood", "walnut"}};
  plan.room.materials.floor = "white tile floor";
  PlanItem wardrobe, sofa;
  wardrobe.category = wardrobe.description = "wardrobe";
  sofa.category = "sofa";
  sofa.description = "a red velvet sofa";
  plan.items = {wardrobe, sofa};
  plan = settled(plan);
  CHECK(plan.room.materials.floor == "white tile floor");
  CHECK(plan.room.materials.walls == "sage walls");
  CHECK(plan.items[0].description == "walnut wardrobe");
  CHECK(plan.items[1].description == "a red velvet sofa");
}
