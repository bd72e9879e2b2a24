#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.h"
#include "roomgen/lab/compose.h"
#include "roomgen/geometry/polygon.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

const std::vector<std::string> prompts = {
    "a bedroom for two with a desk",
    "a dining room with seating for 12 and two china cabinets",
    "a classroom with 12 desks and 12 chairs in three rows",
    "a library with twelve bookshelves and few seats",
    "an office with six desks, six office chairs and 45 % of the floor covered",
    "kitchen with an island and three bar stools",
    "a nursery: crib, changing table, dresser, rocking chair",
    "a very cluttered workshop with two workbenches",
    "laundry room with two washing machines, two dryers and a shelf",
    "a waiting room with about a dozen chairs and a plant, 20 m2",
    "living room with a loveseat, three armchairs and a piano, more than 20 objects in all",
    "a gym with four treadmills and three exercise bikes, 8 x 6 m",
    "a room with a gong and a harp",
    "a workshop with a flux capacitor, two widgets, a desk and a veneer",
    "a studio with a fax machine and a hookah",
    "a bathroom",
};

WrittenProgram written(const std::string& prompt, const Complexity& complexity = {}, std::optional<Vec2> size = {}) {
  ComposeRequest request;
  request.plan.prompt = prompt;
  request.plan.seed = 1;
  request.plan.size = size;
  request.complexity = complexity;
  auto result = write_program(request);
  INFO(prompt);
  REQUIRE(result);
  return *std::move(result);
}

std::optional<CountBound> bound_on(const ConstraintProgram& program, const std::string& set) {
  for (const auto& bound : count_bounds(program))
    if (bound.variables.empty() && bound.set->name == set) return bound;
  return std::nullopt;
}

double floor_of(const WrittenProgram& written) { return area(written.plan.room.polygon); }

}  // namespace

TEST_CASE("Programs written by rules are sound, whole and survive their files", "[compose]") {
  for (const auto& prompt : prompts) {
    INFO(prompt);
    const auto result = written(prompt);
    for (const auto& finding : check(result.program, KindTable::built_in())) {
      INFO(finding.at << ": " << finding.message);
      CHECK(finding.severity != ProgramFinding::Severity::error);
    }
    const auto again = program_from_json(to_json(result.program), "again");
    REQUIRE(again);
    CHECK(to_json(*again) == to_json(result.program));
    CHECK(again->sets == result.program.sets);
    // Every set has a bound: nothing else brings its members into the room.
    for (const auto& [name, members] : result.program.sets) CHECK(bound_on(result.program, name));
    CHECK(result.stock.size() == result.program.sets.size());
  }
}

TEST_CASE("What a prompt counts is bounded by just that", "[compose]") {
  const auto office = written("an office with six desks, six office chairs and two bookshelves").program;
  CHECK(bound_on(office, "desk")->low == 6.0);
  CHECK(bound_on(office, "desk")->high == 6.0);
  CHECK(bound_on(office, "bookshelf")->high == 2.0);
  const auto waiting = written("a waiting room with 8 to 12 armchairs").program;
  CHECK(bound_on(waiting, "armchair")->low == 8.0);
  CHECK(bound_on(waiting, "armchair")->high == 12.0);
  // A dresser is no changing table, though the one is a kind of the other: two of both in all.
  const auto nursery = written("a nursery with a changing table and a dresser").program;
  CHECK(bound_on(nursery, "changing table")->high == 1.0);
  CHECK(bound_on(nursery, "dresser")->low == 2.0);
}

TEST_CASE("The floor is made for the occupancy, unless somebody gave it", "[compose]") {
  const std::string prompt = "an office with four desks and four office chairs, ";
  const double dense = floor_of(written(prompt + "40 % of the floor covered"));
  const double sparse = floor_of(written(prompt + "10 % of the floor covered"));
  CHECK(dense < 0.5 * sparse);
  const auto given = written(prompt + "40 % of the floor covered", {}, Vec2(7.0, 6.0));
  CHECK(std::abs(floor_of(given) - 42.0) < 0.1);
  CHECK_FALSE(given.is_room_free);
  const auto said = written("an office of 30 m2 with four desks, 20 % of the floor covered");
  CHECK(std::abs(floor_of(said) - 30.0) < 0.2);
}

TEST_CASE("A request's numbers come before the prompt's", "[compose]") {
  Complexity told;
  told.seats = Range{3, 4};
  const auto result = written("a lounge with seating for ten", told);
  REQUIRE(result.asked.seats);
  CHECK(result.asked.seats->low == 3.0);
  CHECK(result.asked.seats->high == 4.0);
}

TEST_CASE("What found no place at all leaves its usual places, what found some only the walls", "[compose]") {
  const WrittenProgram before = written("a dining room with a dining table and four dining chairs around it");
  const auto relations_of = [](const WrittenProgram& program) {
    const auto chairs = std::ranges::find(program.program.sets, "dining chair", &NamedSets::value_type::first);
    REQUIRE(chairs != program.program.sets.end());
    return chairs->second.relations;
  };
  REQUIRE(relations_of(before).size() > 1);
  ErrorReport report;
  report.unmet.push_back({.name = "dining chair", .held = false, .amount = 4.0});
  const auto freed = revise(before, report, 1);
  REQUIRE(freed);
  CHECK(freed->reason == "away from where such things usually stand: dining chair");
  CHECK(relations_of(freed->written) == std::vector{relations_of(before).front()});
  report.counts["dining chair"] = 2;
  const auto kept = revise(before, report, 1);
  REQUIRE(kept);
  CHECK(relations_of(kept->written) == relations_of(before));
}
