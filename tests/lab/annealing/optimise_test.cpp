// Rooms from programs: valid whatever happens, the same for any number of threads, honest about what is missed.

#include "roomgen/lab/optimise.h"

#include <nlohmann/json.hpp>

#include "box_stock.h"
#include "catch.h"
#include "roomgen/evaluate/report.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

ConstraintProgram program_of(const std::string& text) {
  const auto json = parse_json(text, "test");
  REQUIRE(json);
  auto program = program_from_json(*json, "test");
  if (!program) FAIL(program.error().message);
  return *program;
}

Optimisation furnish(const ConstraintProgram& program, const OptimiseOptions& options) {
  std::vector<std::string> notes;
  const auto room = room_of(program, options.seed, notes);
  REQUIRE(room);
  auto result = optimise(program, *room, box_stock(program, KindTable::built_in()), KindTable::built_in(), options);
  if (!result) FAIL(result.error().message);
  return *result;
}

OptimiseOptions quick(std::uint64_t seed, int steps = 6000) {
  OptimiseOptions options;
  options.seed = seed;
  options.steps = steps;
  return options;
}

}  // namespace

TEST_CASE("Every room is valid, early and late") {
  for (const auto& path : example_programs())
    for (const int steps : {50, 500, 5000}) {
      INFO(path << ", " << steps << " steps");
      const auto result = furnish(*read_program(path), quick(static_cast<std::uint64_t>(steps), steps));
      const auto report = examine(result.scene, {}, KindTable::built_in());
      for (const auto& violation : report.violations)
        UNSCOPED_INFO(name(violation.fault) << " " << violation.object << " " << violation.other);
      CHECK(report.violations.empty());
      CHECK(report.relations_held() == static_cast<int>(report.relations.size()));
      CHECK(check(result.scene));
    }
}

TEST_CASE("What multiplies without end is refused, or known once, before anything is tried") {
  std::string truth = R"([">", ["dist", "$v0", "$v7"], 0])", sets = R"("s0": {"factory": "sofa"})";
  for (int i = 8; i-- > 0;) truth = R"(["all", "v)" + std::to_string(i) + R"(", "s0", )" + truth + "]";
  const auto deep = program_of(R"({"room": {"type": "lounge", "width": 9, "depth": 9}, "sets": {)" + sets +
                               R"(}, "constraints": {"n": ["in", ["count", "s0"], 3, 10], "deep": )" + truth + "}}");
  std::vector<std::string> notes;
  const auto refused = optimise(deep, *room_of(deep, 1, notes), box_stock(deep, KindTable::built_in()),
                                KindTable::built_in(), quick(1));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("/constraints/deep: one look") != std::string::npos);
  // Sets of ever more of the same.
  for (int i = 1; i < 15; ++i) {
    const std::string before = '"' + std::string("s") + std::to_string(i - 1) + '"';
    sets += R"(, "s)" + std::to_string(i) + R"(": {"union": [)" + before + ", " + before + ", " + before + "]}";
  }
  const auto doubled = program_of(R"({"room": {"type": "lounge", "width": 9, "depth": 9}, "sets": {)" + sets +
                                  R"(}, "constraints": {"n": ["in", ["count", "s14"], 2, 2]}})");
  CHECK(furnish(doubled, quick(1, 500)).scene.objects.size() == 2);
}

TEST_CASE("The number of threads does not matter") {
  const auto program = *read_program(example_programs().back());
  auto options = quick(4, 3000);
  options.chains = 3;
  options.threads = 1;
  const auto one = to_json(furnish(program, options).scene);
  options.threads = 3;
  CHECK(to_json(furnish(program, options).scene) == one);
}

TEST_CASE("Counts are exact when there is room") {
  for (const int wanted : {1, 5, 12}) {
    const auto program = program_of(R"({"room": {"type": "classroom", "width": 8, "depth": 9},
      "sets": {"desk": {"factory": "desk", "rel": [["on_floor", "room"]]}},
      "constraints": {"desks": ["==", ["count", "desk"], )" + std::to_string(wanted) + "]}}");
    const auto result = furnish(program, quick(2));
    CHECK(static_cast<int>(result.scene.objects.size()) == wanted);
    CHECK(result.violation == 0.0);
  }
}

TEST_CASE("What cannot be is missed by what it says") {
  const auto program = program_of(R"({"room": {"type": "bedroom", "width": 2.6, "depth": 3.2},
    "sets": {"bed": {"factory": "double bed", "rel": [["on_floor", "room"]]}},
    "constraints": {"beds": ["==", ["count", "bed"], 2]}})");
  const auto result = furnish(program, quick(1));
  REQUIRE(result.constraints.size() == 1);
  const auto& verdict = result.constraints.front();
  CHECK_FALSE(verdict.held);
  CHECK(verdict.amount == 2.0 - static_cast<double>(result.scene.objects.size()));
  REQUIRE(result.scene.program.size() == 1);
  CHECK(result.scene.program.front().amount == verdict.amount);
}

TEST_CASE("Occupancy comes near its target") {
  for (const double target : {0.15, 0.3, 0.45}) {
    const std::string low = std::to_string(target - 0.02), high = std::to_string(target + 0.02);
    const auto program = program_of(R"({"room": {"type": "living room", "width": 5, "depth": 4},
      "sets": {"furn": {"tags": ["furniture"], "rel": [["on_floor", "room"]]}},
      "constraints": {"fill": ["in", ["occupancy", "objects"], )" + low + ", " + high + R"(],
                      "some": ["in", ["count", "furn"], 2, 40]}})");
    const auto result = furnish(program, quick(9, 60000));
    CHECK(result.occupancy == Approx(target).margin(0.03));
  }
}

TEST_CASE("Stopping keeps a valid room and says that it is not all") {
  auto options = quick(1, 2000000);
  options.cancel = CancelToken().within(std::chrono::duration<double>(0.3));
  const auto result = furnish(*read_program(example_programs().front()), options);
  CHECK(result.scene.incomplete);
  CHECK(examine(result.scene, {}, KindTable::built_in()).violations.empty());
}

TEST_CASE("An unsound program is refused") {
  const auto program = program_of(R"({"room": {"type": "bedroom"}, "sets": {},
    "constraints": {"beds": ["==", ["count", "bed"], 3]}})");
  const auto result = optimise(program, Room{"bedroom", *make_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})}, {}, KindTable::built_in());
  REQUIRE_FALSE(result);
  CHECK(result.error().message.find("bed") != std::string::npos);
}

TEST_CASE("Of constraints that conflict those that are innocent are left out") {
  const auto program = program_of(R"({"room": {"type": "bedroom", "width": 2.6, "depth": 2.8},
    "sets": {"bed": {"factory": "double_bed", "rel": [["on_floor", "room"]]}, "desk": {"factory": "desk", "rel": [["on_floor", "room"]]},
             "picture": {"factory": "picture", "rel": [["flush_wall", "room"]]}},
    "constraints": {"a picture": ["==", ["count", "picture"], 1], "a bed": ["==", ["count", "bed"], 1],
                    "desks": ["==", ["count", "desk"], 3]}, "scores": {}})");
  std::vector<std::string> notes;
  const auto room = room_of(program, 1, notes);
  REQUIRE(room);
  const auto names = conflict(program, *room, box_stock(program, KindTable::built_in()), KindTable::built_in(), quick(1));
  REQUIRE(names);
  CHECK(std::ranges::find(*names, "a picture") == names->end());
  CHECK(std::ranges::find(*names, "desks") != names->end());
}
