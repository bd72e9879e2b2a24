// What a plan can say, made by generate() without the command line.
#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "small_plans.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

Generation made(const Plan& plan) {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  auto generation = generate(plan, *designer, *library, KindTable::built_in());
  REQUIRE(generation);
  return *std::move(generation);
}

}  // namespace

TEST_CASE("Openings that a plan wants are in the room, and what cannot be is told") {
  Plan plan = rooms::plan_of({rooms::item("chair")}, rooms::box(5, 4));
  WantedOpening door, window;
  door.kind = "door";
  door.at = 0.5;
  door.wall = "south";
  window.kind = "window";
  window.at = 0.0;  // beyond the corner
  window.wall = "east";
  plan.openings = {door, window};
  const Generation generation = made(plan);
  REQUIRE(generation.scene.room.openings.size() == 1);
  CHECK(generation.scene.room.openings[0].from > 2.0);
  REQUIRE(generation.notes.size() == 1);
  CHECK(contains_text(generation.notes[0], "/openings/1"));
}
