#include <cmath>
#include <numeric>
#include <vector>

#include "catch.h"
#include "plans.h"

using namespace roomgen;
using namespace roomgen::test;

namespace {

std::vector<const PlanItem*> in_places(const Plan& plan, const std::string& kind) {
  std::vector<const PlanItem*> placed;
  for (const auto& item : plan.items)
    if (item.location && item.facing && KindTable::built_in().is_a(item.category, kind)) placed.push_back(&item);
  return placed;
}

const Requirement* clause(const Plan& plan, std::string_view attribute) {
  for (const auto& requirement : plan.requirements)
    if (requirement.attribute == attribute) return &requirement;
  return nullptr;
}

Vec2 front_of(const PlanItem& item) { return {std::sin(*item.facing), -std::cos(*item.facing)}; }

}  // namespace

TEST_CASE("things in a circle are planned at one distance from its middle, facing it, clear of each other") {
  struct Case {
    const char* prompt;
    const char* kind;
    std::size_t count;
  };
  for (const Case& one : {Case{"eight chairs in a circle", "chair", 8}, Case{"a circle of ten stools in a hall", "stool", 10},
                          Case{"a therapy room with a ring of six armchairs around a low table", "armchair", 6}})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(one.prompt << ", seed " << seed);
      const Plan plan = plan_of(one.prompt, seed);
      CHECK(clause(plan, in_circle));
      const auto placed = in_places(plan, one.kind);
      REQUIRE(placed.size() == one.count);
      Vec2 middle = Vec2::Zero();
      for (const auto* item : placed) middle += *item->location / static_cast<double>(placed.size());
      const double radius = (*placed[0]->location - middle).norm();
      for (std::size_t i = 0; i < placed.size(); ++i) {
        CHECK(contains(plan.room.polygon, *placed[i]->location));
        CHECK((*placed[i]->location - middle).norm() == Approx(radius).margin(0.01));
        CHECK(front_of(*placed[i]).dot((middle - *placed[i]->location).normalized()) > 0.999);
        for (std::size_t j = 0; j < i; ++j)
          CHECK((*placed[i]->location - *placed[j]->location).norm() >= placed[i]->size->x());
      }
    }
}

TEST_CASE("an arc is open towards what its things face") {
  for (const char* prompt : {"seven chairs in a half circle facing a fireplace", "a horseshoe of seven chairs facing a screen"})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(prompt << ", seed " << seed);
      const Plan plan = plan_of(prompt, seed);
      CHECK(clause(plan, in_arc));
      const auto placed = in_places(plan, "chair");
      REQUIRE(placed.size() == 7);
      Vec2 sum = Vec2::Zero();
      for (const auto* item : placed) sum += front_of(*item);
      // All look towards one side: a whole circle's sum would be nothing.
      CHECK(sum.norm() > 0.4 * static_cast<double>(placed.size()));
    }
}

TEST_CASE("a circle is no circle rug, and what nobody sits around is left alone") {
  CHECK_FALSE(clause(plan_of("a bedroom with a circle rug and two chairs"), in_circle));
  CHECK_FALSE(clause(plan_of("a studio with a ring light and three stools"), in_circle));
}
