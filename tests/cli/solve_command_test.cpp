#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "support/contains.h"

namespace {

const std::string data = ROOMGEN_TEST_DATA;

}  // namespace

TEST_CASE("A solved problem is a scene that passes the check, the same every time") {
  const TemporaryFolder folder;
  const std::string problem = data + "/solver-scenes/balcony.json";
  const auto solved = run({"solve", problem, "-o", folder / "a.json", "--seed", "5"});
  INFO(solved.err);
  REQUIRE(solved.code == 0);
  CHECK(contains_text(solved.out, "6 of 6 objects placed"));
  CHECK(run({"check", folder / "a.json"}).code == 0);
  REQUIRE(run({"solve", problem, "-o", folder / "b.json", "--seed", "5"}).code == 0);
  CHECK(*roomgen::read_file(folder / "a.json") == *roomgen::read_file(folder / "b.json"));
}

TEST_CASE("The largest seed that is accepted makes a scene that can be read again") {
  const TemporaryFolder folder;
  const std::string problem = data + "/solver-scenes/balcony.json";
  for (const char* seed : {"0", "9007199254740991", "9007199254740993", "18446744073709551615"}) {
    const auto solved = run({"solve", problem, "-o", folder / "a.json", "--seed", seed, "--rounds", "0"});
    INFO(seed << ": " << solved.err);
    if (solved.code != 0) CHECK((failed_in_one_line(solved, 1) || failed_in_one_line(solved, 2)));
    else CHECK(run({"check", folder / "a.json"}).err.empty());
  }
}

TEST_CASE("Things without a place are no failure, unless one is strict") {
  const TemporaryFolder folder;
  const std::string problem = data + "/rooms/90-too-large.json";
  const auto lenient = run({"solve", problem, "-o", folder / "a.json"});
  CHECK(lenient.code == 0);
  CHECK(contains_text(lenient.out, "no place for piano-0"));
  const auto strict = run({"solve", problem, "-o", folder / "a.json", "--strict"});
  CHECK(strict.code == 1);
  CHECK(contains_text(*roomgen::read_file(folder / "a.json"), "piano-0"));
}

TEST_CASE("A scene that breaks a rule fails the check, which says what and who") {
  const TemporaryFolder folder;
  REQUIRE(roomgen::write_file(folder / "s.json", R"({"format": "roomgen-scene", "version": 1,
    "room": {"polygon": [[0,0],[4,0],[4,4],[0,4]]},
    "objects": [{"id": "box-0", "size": [1,1,1], "position": [0.2,2,0]},
                {"id": "box-1", "size": [1,1,1], "position": [2,2,0]},
                {"id": "box-2", "size": [1,1,1], "position": [2.5,2,0]}]})"));
  const auto ended = run({"check", folder / "s.json"});
  CHECK(ended.code == 1);
  CHECK(contains_text(ended.out, "outside: box-0"));
  CHECK(contains_text(ended.out, "overlap: box-2 and box-1"));
}
