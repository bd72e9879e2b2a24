#include <cmath>
#include <numeric>
#include <vector>

#include "catch.h"
#include "plans.h"

using namespace roomgen;
using namespace roomgen::test;

namespace {

const Requirement* clause(const Plan& plan, std::string_view attribute) {
  for (const auto& requirement : plan.requirements)
    if (requirement.attribute == attribute) return &requirement;
  return nullptr;
}

Vec2 front_of(const Footprint& thing) { return {std::sin(thing.yaw()), -std::cos(thing.yaw())}; }

}  // namespace

TEST_CASE("things in a circle are planned at one distance from its middle, facing it, clear of each other") {
  struct Case {
    const char* prompt;
    std::size_t count;
  };
  for (const Case& one : {Case{"eight chairs in a circle", 8}, Case{"a circle of ten stools in a hall", 10},
                          Case{"a therapy room with a ring of six armchairs around a low table", 6}})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(one.prompt << ", seed " << seed);
      const Plan plan = plan_of(one.prompt, seed);
      CHECK(clause(plan, in_circle));
      const auto placed = test::in_block(plan);
      REQUIRE(placed.size() == one.count);
      Vec2 middle = Vec2::Zero();
      for (const auto& thing : placed) middle += thing.center() / static_cast<double>(placed.size());
      const double radius = (placed[0].center() - middle).norm();
      for (std::size_t i = 0; i < placed.size(); ++i) {
        CHECK((placed[i].center() - middle).norm() == Approx(radius).margin(0.01));
        CHECK(front_of(placed[i]).dot((middle - placed[i].center()).normalized()) > 0.999);
        for (std::size_t j = 0; j < i; ++j) CHECK(gap(placed[i], placed[j]) > 0.0);
      }
    }
}

TEST_CASE("an arc is open towards what its things face") {
  for (const char* prompt : {"seven chairs in a half circle facing a fireplace", "a horseshoe of seven chairs facing a screen"})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(prompt << ", seed " << seed);
      const Plan plan = plan_of(prompt, seed);
      CHECK(clause(plan, in_arc));
      const auto placed = test::in_block(plan);
      REQUIRE(placed.size() == 7);
      Vec2 sum = Vec2::Zero();
      for (const auto& thing : placed) sum += front_of(thing);
      // All look towards one side: a whole circle's sum would be nothing.
      CHECK(sum.norm() > 0.4 * static_cast<double>(placed.size()));
    }
}

TEST_CASE("a circle is no circle rug, and what nobody sits around is left alone") {
  CHECK_FALSE(clause(plan_of("a bedroom with a circle rug and two chairs"), in_circle));
  CHECK_FALSE(clause(plan_of("a studio with a ring light and three stools"), in_circle));
}
