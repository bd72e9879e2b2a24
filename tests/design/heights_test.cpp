#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "catch.h"
#include "plans.h"
#include "read_brief.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

// Metres from the floor to the middle of the first thing of a category; 0 if nothing is said.
double height_of(const std::string& prompt, const std::string& category) {
  for (const auto& item : test::plan_of(prompt).items)
    if (item.category == category) return item.height.value_or(0.0);
  return -1.0;
}

// Of the thing asked for with that side; nothing if none was.
std::optional<double> asked(const Plan& plan, const std::string& side) {
  for (const auto& requirement : plan.requirements)
    if (requirement.kind == Requirement::Kind::attribute && requirement.attribute == side) return requirement.amount;
  return std::nullopt;
}

}  // namespace

TEST_CASE("How high a thing hangs is read wherever the sentence says it") {
  struct Said {
    const char *prompt, *category;
    double height;
  };
  const Said said[] = {
      {"A living room with a television at 1.8 m and a sofa.", "wall tv", 1.8},
      {"A study with two wall shelves 1.5 m above the floor.", "wall shelves", 1.5},
      {"A hall. A mirror hangs on the back wall at a height of 160 cm above a bench.", "mirror", 1.6},
      {"A bedroom with a picture above the bed, 5 feet off the floor.", "picture", 1.524},
      {"A hall with a clock above a bench at 2 m.", "wall clock", 2.0},
      {"An office where, at 1.4 m above the floor, a whiteboard hangs.", "whiteboard", 1.4},
  };
  for (const auto& [prompt, category, height] : said) {
    INFO(prompt);
    CHECK(std::abs(height_of(prompt, category) - height) < 1e-3);
  }
}

TEST_CASE("A size, an interval and a distance from something else are no height above the floor") {
  for (const char* prompt : {"A hall with a mirror 1.6 m high.", "A hall with pictures at 2 m intervals.",
                             "A kitchen with a wall shelf 0.5 m above the counter.", "A study with a wall shelf 1.2 m wide."}) {
    INFO(prompt);
    for (const auto& item : test::plan_of(prompt).items) CHECK_FALSE(item.height);
  }
}

TEST_CASE("Sizes and heights that no thing has are asked for as they are told, and planned as well as can be") {
  struct Said {
    const char *prompt, *side;
    double metres;
  };
  for (const auto& [prompt, side, metres] :
       {Said{"A hall with a mirror hung at 99999999999999999999 cm.", "height above the floor", 1000.0},
        Said{"A hall with a mirror hung at 40 m.", "height above the floor", 40.0},
        Said{"A hall with a bench 30 m wide.", "width", 30.0}, Said{"A hall with a bench 1 cm high.", "height", 0.01},
        Said{"A hall with a bench 99999999999999999999 m wide.", "width", 1000.0},
        Said{"A hall with a 99999999999999999999 x 0.5 bench.", "width", 1000.0}}) {
    INFO(prompt);
    const Plan plan = test::plan_of(prompt);
    CHECK(plan_from_json(to_json(plan), "plan.json"));
    const auto amount = asked(plan, side);
    REQUIRE(amount);
    CHECK(std::abs(*amount - metres) < 1e-3);
    for (const auto& item : plan.items) {
      CHECK((!item.size || item.size->maxCoeff() <= 10.0));
      CHECK(item.height.value_or(0.0) <= 10.0);
    }
  }
}
