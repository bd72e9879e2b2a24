// A room that cannot be what it is called is no success.
#include <cstdio>
#include <optional>
#include <string>

#include "brief/room_kinds.h"
#include "catch.h"
#include "plans.h"
#include "roomgen/design/designer.h"
#include "support/contains.h"
#include "support/error_of.h"

using namespace roomgen;
using roomgen::test::count_of;

namespace {

Result<Plan> plan_in(const std::string& prompt, const Vec2& size, std::uint64_t seed = 0) {
  PlanRequest request;
  request.prompt = prompt;
  request.size = size;
  request.seed = seed;
  return make_rule_designer()->plan(request);
}

// "...; 2.3 x 2.1 m is the least size that would do"
std::optional<Vec2> least_of(const std::string& message) {
  const auto at = message.rfind("; ");
  Vec2 least;
  if (at == std::string::npos || std::sscanf(message.c_str() + at, "; %lf x %lf m is the least", &least.x(), &least.y()) != 2)
    return std::nullopt;
  return least;
}

bool holds_a_maker(const Plan& plan, const std::string& type) {
  for (const auto& maker : brief::built_in_room_kinds()->get(type).made_by)
    if (count_of(plan, maker) > 0) return true;
  return false;
}

}  // namespace

TEST_CASE("What makes a room what it is exists, and such a room always gets it") {
  for (const auto& [type, kind] : brief::built_in_room_kinds()->types) {
    INFO(type);
    for (const auto& maker : kind.made_by) CHECK(KindTable::built_in().all().count(maker) == 1);
    const auto gives_maker = [&](const brief::Piece& piece) {
      bool gives = piece.chance == 1.0 && piece.area == 0.0 && piece.needs.empty();
      for (const auto& [category, weight] : piece.any)
        gives = gives && KindTable::built_in().is_any_of(category, kind.made_by);
      return gives;
    };
    CHECK((kind.made_by.empty() || std::any_of(kind.core.begin(), kind.core.end(), gives_maker)));
  }
}

TEST_CASE("A room too small for what makes it is refused with what it lacks and the least size that does") {
  struct Case {
    std::string type, lacks;
    Vec2 size;
  };
  const Case cases[] = {{"bedroom", "no bed", {2, 2}},        {"bedroom", "no bed", {0.5, 0.5}},
                        {"bedroom", "no bed", {1, 6}},        {"bathroom", "no toilet", {0.5, 0.5}},
                        {"kitchen", "no stove", {0.5, 0.5}},  {"living room", "no seat", {0.5, 0.6}},
                        {"study", "no desk", {0.6, 0.5}},     {"dining room", "no table", {0.5, 0.5}},
                        {"kids room", "no bed", {1.2, 1.2}},  {"conference room", "no table", {1, 1}},
                        {"laundry room", "no washing machine", {0.5, 0.5}}};
  for (const auto& [type, lacks, size] : cases) {
    const auto refused = plan_in("a " + type, size);
    INFO(type << ": " << error_of(refused));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().kind == Error::Kind::too_small);
    CHECK(contains_text(refused.error().message, lacks));
    const auto least = least_of(refused.error().message);
    REQUIRE(least);
    CHECK((least->x() >= size.x() && least->y() >= size.y()));
    const auto made = plan_in("a " + type, *least);
    REQUIRE(made);
    CHECK(holds_a_maker(*made, type));
    for (const Vec2& step : {Vec2(0.1, 0.0), Vec2(0.0, 0.1)})
      if (const Vec2 less = *least - step; (less.array() > size.array() - 0.01).all()) CHECK_FALSE(plan_in("a " + type, less));
  }
}

TEST_CASE("A room needs nothing that its prompt does not want") {
  for (const char* prompt : {"a bedroom without a bed", "an empty bedroom", "a bedroom with nothing but a lamp",
                             "a balcony", "a lamp and a vase"}) {
    INFO(prompt);
    const auto plan = plan_in(prompt, {1.5, 1.5});
    CHECK(error_of(plan) == "");
  }
  CHECK(contains_text(error_of(plan_in("a bathroom without a toilet", {0.5, 0.5})), "no bathtub or shower"));
  CHECK(contains_text(error_of(plan_in("a bedroom with a bed", {2, 2})), "no bed"));
  CHECK(contains_text(error_of(plan_in("a bedroom for two", {2, 2})), "no bed"));
}

TEST_CASE("A floor plan and the rooms of a dwelling are held to what they are called too") {
  PlanRequest request;
  request.prompt = "a bedroom";
  request.room.emplace();
  request.room->polygon.points = {{0, 0}, {2, 0}, {2, 1.8}, {0, 1.8}};
  const auto refused = make_rule_designer()->plan(request);
  CHECK(contains_text(error_of(refused), "a bedroom of 2 x 1.8 m cannot be one: no bed"));
}

TEST_CASE("A size in the prompt and another beside it are one contradiction, told once, with who wins") {
  struct Case {
    std::string prompt;
    Vec2 size;
    int contradictions;
  };
  const Case cases[] = {{"a 4x5 m bedroom", {3, 3}, 1},   {"a 4x5 m bedroom", {4, 3}, 1}, {"a 4x5 m bedroom", {5, 4}, 0},
                        {"a 20 m2 bedroom", {3, 3}, 1},   {"a 20 m2 bedroom", {4, 5}, 0}, {"a bedroom", {3, 3}, 0}};
  for (const auto& [prompt, size, contradictions] : cases) {
    INFO(prompt << " of " << size.x() << " x " << size.y());
    const auto plan = plan_in(prompt, size);
    REQUIRE(plan);
    int told = 0, sizes = 0;
    for (const auto& requirement : plan->requirements) {
      told += contains_text(requirement.clause, "the size that is given, 3 x 3 m, wins") ||
              contains_text(requirement.clause, "the size that is given, 4 x 3 m, wins");
      sizes += requirement.attribute == "longer side" || requirement.attribute == "shorter side" || requirement.attribute == "area";
    }
    for (const auto& note : plan->notes) told += contains_text(note, "wins");
    CHECK(told == contradictions);
    if (contradictions > 0) CHECK(sizes == 1);
  }
}
