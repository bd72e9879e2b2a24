// What is furnished is what it is called, or a failure.
#include <cstdio>
#include <string>

#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/generate/room_builder.h"
#include "small_plans.h"
#include "support/contains.h"
#include "support/error_of.h"

using namespace roomgen;

namespace {

Result<Generation> furnished(const Plan& plan) {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  return generate(plan, *designer, *library, KindTable::built_in());
}

Result<Plan> planned(const std::string& prompt, const Vec2& size) {
  PlanRequest request;
  request.prompt = prompt;
  request.size = size;
  return make_rule_designer()->plan(request);
}

/// A bedroom of which somebody has said what it holds.
Plan bedroom(double width, double depth, std::vector<PlanItem> items) {
  Plan plan = rooms::plan_of(std::move(items), rooms::room_with_door(width, depth));
  plan.room.type = "bedroom";
  return plan;
}

bool holds(const Generation& made, const std::string& kind) {
  for (const auto& object : made.scene.objects)
    if (KindTable::built_in().is_a(object.category, kind)) return true;
  return false;
}

}  // namespace

TEST_CASE("In the least size that a refusal names the room is furnished with what makes it") {
  struct Case {
    std::string type, maker;
  };
  for (const auto& [type, maker] : {Case{"bedroom", "bed"}, Case{"living room", "seat"}, Case{"kids room", "bed"},
                                    Case{"study", "desk"}, Case{"dining room", "table"}}) {
    const std::string refusal = error_of(planned("a " + type, {0.5, 0.5}));
    INFO(type << ": " << refusal);
    Vec2 least;
    const auto at = refusal.rfind("; ");
    REQUIRE(at != std::string::npos);
    REQUIRE(std::sscanf(refusal.c_str() + at, "; %lf x %lf m", &least.x(), &least.y()) == 2);
    const auto plan = planned("a " + type, least);
    REQUIRE(plan);
    const auto made = furnished(*plan);
    REQUIRE(made);
    CHECK(holds(*made, maker));
  }
}

TEST_CASE("Of a plan that somebody made only what was planned and found no place is a failure") {
  const PlanItem bed = rooms::item("bed"), lamp = rooms::item("floor lamp");
  const auto refused = furnished(bedroom(2, 2, {bed, lamp}));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == Error::Kind::too_small);
  CHECK(contains_text(refused.error().message, "a bedroom of 2 x 2 m cannot be one: no bed finds a place in it"));
  double width = 0, depth = 0;
  REQUIRE(std::sscanf(refused.error().message.c_str() + refused.error().message.rfind("; "), "; %lf x %lf m is the least", &width, &depth) == 2);
  const auto larger = furnished(bedroom(width, depth, {bed}));
  INFO(error_of(refused));
  REQUIRE(larger);
  CHECK(holds(*larger, "bed"));

  CHECK(furnished(bedroom(2, 2, {lamp})));  // left out on purpose
}

TEST_CASE("A builder says whether its room is what it is called once all was tried") {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  auto builder = RoomBuilder::begin(bedroom(2, 2, {rooms::item("bed")}), *designer, *library, KindTable::built_in());
  REQUIRE(builder);
  CHECK(builder->check_kind());  // not tried yet
  REQUIRE(builder->step());
  CHECK(contains_text(error_of(builder->check_kind()), "no bed finds a place"));
}

TEST_CASE("Of a dwelling the room that is not what it is called is named") {
  DwellingPlan dwelling;
  dwelling.rooms = {bedroom(2, 2, {rooms::item("bed")})};
  dwelling.rooms[0].room.id = "bedroom-0";
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  const auto refused = generate(dwelling, *designer, *library, KindTable::built_in());
  CHECK(contains_text(error_of(refused), "room \"bedroom-0\": a bedroom of 2 x 2 m cannot be one"));
}

TEST_CASE("The least size that a prompt is told makes the room, planned and furnished anew") {
  const auto designer = make_rule_designer();
  const auto library = create::make_created_library();
  const KindTable& kinds = KindTable::built_in();
  const auto ended = [&](const PlanRequest& request) -> Status {
    const auto plan = designer->plan(request);
    if (!plan) return plan.error();
    const auto made = generate(*plan, *designer, *library, kinds);
    return made ? Status() : Status(made.error());
  };
  for (const char* prompt : {"a bedroom with a desk", "a bedroom with two beds", "an office", "a laundry room"}) {
    PlanRequest request;
    request.prompt = prompt;
    request.size = Vec2(1.2, 1.5);
    const Status refused = ended(request);
    REQUIRE_FALSE(refused);
    const Error told = with_least_size(refused.error(), request, *library, kinds);
    INFO(told.message);
    Vec2 least;
    REQUIRE(std::sscanf(told.message.c_str() + told.message.rfind("; "), "; %lf x %lf m is the least", &least.x(),
                        &least.y()) == 2);
    request.size = least;
    CHECK(error_of(ended(request)) == "");
  }
}
