#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

namespace {

}  // namespace

TEST_CASE("A solved problem is a scene that passes the check, the same every time") {
  const TemporaryFolder folder;
  const std::string problem = test_data + "/solver-scenes/balcony.json";
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
  const std::string problem = test_data + "/solver-scenes/balcony.json";
  for (const char* seed : {"0", "9007199254740991", "9007199254740993", "18446744073709551615"}) {
    const auto solved = run({"solve", problem, "-o", folder / "a.json", "--seed", seed, "--rounds", "0"});
    INFO(seed << ": " << solved.err);
    if (solved.code != 0) CHECK((failed_in_one_line(solved, 1) || failed_in_one_line(solved, 2)));
    else CHECK(run({"check", folder / "a.json"}).err.empty());
  }
}

TEST_CASE("Things without a place are no failure, unless one is strict") {
  const TemporaryFolder folder;
  const std::string problem = test_data + "/rooms/90-too-large.json";
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

TEST_CASE("Layouts are drawn one a line, the same for any number of threads, and pass the check") {
  const TemporaryFolder folder;
  const std::string problem = test_data + "/solver-scenes/living_room.json";
  const auto drawn =
      run({"solve", problem, "--samples", "40", "--seed", "5", "-o", folder / "a.jsonl", "--threads", "1"});
  INFO(drawn.err);
  REQUIRE(drawn.code == 0);
  CHECK(contains_text(drawn.out, "40 of 40 distinct layouts were found"));
  const std::string lines = *roomgen::read_file(folder / "a.jsonl");
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 40);
  const auto other = run({"solve", problem, "--samples", "40", "--seed", "5", "--threads", "2"});
  CHECK(other.out == lines);
  CHECK(contains_text(other.err, "40 of 40"));
  const auto checked = run({"check", folder / "a.jsonl", "--of", problem});
  CHECK(checked.code == 0);
  CHECK(contains_text(checked.out, "40 layouts, 0 with faults; 36 to 36 constraints held"));
}

TEST_CASE("Layouts are drawn of a plan, with the room beside them, and not of what is no single room") {
  const TemporaryFolder folder;
  const auto plan = folder / "plan.json";
  REQUIRE(run({"plan", "a bedroom", "-o", plan}).code == 0);
  const auto drawn = run({"solve", plan, "--samples", "20", "-o", folder / "a.jsonl"});
  INFO(drawn.err);
  REQUIRE(drawn.code == 0);
  CHECK(contains_text(drawn.out, "20 of 20 distinct layouts were found"));
  const auto checked = run({"check", folder / "a.jsonl", "--of", folder / "a.scene.json"});
  CHECK(checked.code == 0);
  CHECK(contains_text(checked.out, "20 layouts, 0 with faults"));
  const auto program = run({"solve", test_data + "/programs/dining.json", "--samples", "3"});
  CHECK(failed_in_one_line(program, 1));
  CHECK(contains_text(program.err, "roomgen optimise"));
  const auto dwelling = folder / "dwelling.json";
  REQUIRE(run({"plan", "a flat with two bedrooms", "-o", dwelling}).code == 0);
  CHECK(failed_in_one_line(run({"solve", dwelling, "--samples", "3"}), 1));
}

TEST_CASE("More layouts than there are end with a clear statement") {
  const TemporaryFolder folder;
  const std::string problem = test_data + "/rooms/92-only-the-door.json";
  const auto drawn = run({"--json", "solve", problem, "--samples", "1000", "-o", folder / "a.jsonl"});
  CHECK(drawn.code == 0);
  const auto summary = roomgen::Json::parse(drawn.out);
  CHECK(summary["wanted"] == 1000);
  CHECK(summary["layouts"].get<int>() > 0);
  CHECK(summary["layouts"].get<int>() < 100);
  CHECK(summary["distinct"].get<double>() < 0.5);
  const auto strict = run({"solve", problem, "--samples", "1000", "--strict"});
  CHECK(strict.code == 1);
  CHECK(contains_text(strict.err, " of 1000 distinct layouts were found"));
}

TEST_CASE("What is no number of layouts is refused") {
  const std::string problem = test_data + "/solver-scenes/balcony.json";
  for (const char* number : {"0", "-3", "1000001", "many"})
    CHECK(failed_in_one_line(run({"solve", problem, "--samples", number}), 2));
  CHECK(failed_in_one_line(run({"solve", problem, "--threads", "2"}), 2));
}

TEST_CASE("The check of layouts says which line is wrong") {
  const TemporaryFolder folder;
  const std::string problem = test_data + "/solver-scenes/balcony.json";
  REQUIRE(run({"solve", problem, "--samples", "3", "-o", folder / "a.jsonl"}).code == 0);
  CHECK(failed_in_one_line(run({"check", folder / "a.jsonl"}), 1));
  const std::string lines = *roomgen::read_file(folder / "a.jsonl");
  auto bad = roomgen::Json::parse(lines.substr(0, lines.find('\n')));
  bad["held"] = 99;
  REQUIRE(roomgen::write_file(folder / "held.jsonl", lines + bad.dump() + "\n"));
  const auto held = run({"check", folder / "held.jsonl", "--of", problem});
  CHECK(failed_in_one_line(held, 1));
  CHECK(contains_text(held.err, "held.jsonl:4"));
  bad.erase("held");
  bad["objects"][0]["position"] = {50.0, 0.0, 0.0};
  REQUIRE(roomgen::write_file(folder / "outside.jsonl", bad.dump() + "\n"));
  const auto outside = run({"check", folder / "outside.jsonl", "--of", problem});
  CHECK(outside.code == 1);
  CHECK(contains_text(outside.out, "outside.jsonl:1: outside"));
}
