#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "roomgen/base/json.h"
#include "support/random_problem.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

std::string bytes(const Problem& problem, std::uint64_t seed) {
  return dump_json(to_json(solved(problem, seed, 5).scene));
}

}  // namespace

TEST_CASE("The same problem and seed give the same bytes") {
  for (std::uint64_t i = 0; i < 4; ++i) {
    const auto problem = rooms::random_problem(i);
    INFO("problem " << i);
    CHECK(bytes(problem, 3) == bytes(problem, 3));
  }
}

TEST_CASE("A scene that is written and read again has the same bytes and still nothing wrong") {
  for (std::uint64_t i = 0; i < 6; ++i) {
    const auto scene = solved(rooms::random_problem(100 + i), i, 2).scene;
    const std::string text = dump_json(to_json(scene));
    const auto json = parse_json(text, "scene");
    REQUIRE(json);
    const auto again = scene_from_json(*json, "scene");
    INFO("problem " << 100 + i);
    REQUIRE(again);
    CHECK(dump_json(to_json(*again)) == text);
    CHECK(violations(*again).empty());
  }
}

TEST_CASE("Another seed may give another room, which the seed in the scene tells") {
  const auto problem =
      read_problem(std::filesystem::path(ROOMGEN_TEST_DATA) / "rooms" / "01-bedroom-rectangle.json");
  REQUIRE(problem);
  std::set<std::string> rooms;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto scene = solved(*problem, seed, 20).scene;
    CHECK(scene.seed == seed);
    auto json = to_json(scene);
    json.erase("seed");
    rooms.insert(dump_json(json));
  }
  CHECK(rooms.size() > 1);
}
