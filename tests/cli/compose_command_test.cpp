#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// Only what is made from words: no furniture has to be there.
struct ComposeFolder {
  TemporaryFolder folder;

  Ended compose(const std::string& prompt, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"compose", prompt, "-o", folder / "room", "--cache", folder / "cache",
                                          "--no-default-libraries", "--no-pictures", "--force", "--steps", "1500",
                                          "--chains", "1", "--assets", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

}  // namespace

TEST_CASE("A sentence with numbers becomes a room that has them") {
  const ComposeFolder shop;
  const auto done = shop.compose("a study with two desks and three bookshelves", {"--seats", "2", "--json"});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  const auto said = parse_json(done.out, "summary");
  REQUIRE(said);
  CHECK((*said)["report"]["met"] == true);
  const auto scene = parse_json(*read_file(shop.folder / "room/scene.json"), "scene.json");
  int desks = 0, shelves = 0;
  for (const auto& object : (*scene)["objects"]) {
    desks += object["category"] == "desk";
    shelves += object["category"] == "bookshelf";
  }
  CHECK((*scene)["requirements"].size() >= 2);
  for (const auto& requirement : (*scene)["requirements"]) CHECK(requirement["verdict"] == "met");
  CHECK(desks == 2);
  CHECK(shelves == 3);
  CHECK(run({"check", shop.folder / "room/scene.json"}).code == 0);
  CHECK(run({"check", shop.folder / "room/program.json"}).code == 0);
  const auto rounds = parse_json(*read_file(shop.folder / "room/rounds.json"), "rounds.json");
  CHECK((*rounds)["rounds"].size() >= 1);
}

TEST_CASE("What cannot be had is said, and strictness makes it a failure") {
  const ComposeFolder shop;
  const auto lenient = shop.compose("a study of 2 x 2.4 m with five desks", {"--rounds", "2"});
  INFO(lenient.err);
  CHECK(lenient.code == 0);
  CHECK(contains_text(lenient.out, "is missed by"));
  CHECK(run({"check", shop.folder / "room/scene.json"}).code == 0);
  CHECK(shop.compose("a study of 2 x 2.4 m with five desks", {"--rounds", "1", "--strict"}).code == 1);
}

TEST_CASE("Wrong input of compose is refused with its place") {
  const ComposeFolder shop;
  const auto range = shop.compose("a study", {"--seats", "12..8"});
  CHECK(range.code != 0);
  CHECK(contains_text(range.err, "--seats"));
  const auto nothing = shop.compose("xyzzy plugh");
  CHECK(nothing.code != 0);
  CHECK(contains_text(nothing.err, "names a room"));
  CHECK(shop.compose("ein Schlafzimmer mit zwei Betten").code != 0);
  CHECK_FALSE(std::filesystem::exists(shop.folder / "room/scene.json"));
}

TEST_CASE("The experiment of programs goes on where it was stopped") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "d.jsonl", R"({"id": "A", "text": "a study with a desk", "expect": {"counts": {"desk": [1, 1]}}})"
                                         "\n"));
  const std::vector<std::string> command = {"experiment", "--programs", folder / "d.jsonl", "-o", folder / "out",
                                            "--cache", ROOMGEN_BINARY_DIR "/test-cache"};
  const auto first = run(command);
  INFO(first.err);
  REQUIRE(first.code == 0);
  CHECK(contains_text(first.out, "| both | 5 |"));
  CHECK(std::filesystem::exists(folder / "out/fidelity.svg"));
  const auto again = run(command);
  CHECK(again.out == first.out);
  CHECK_FALSE(contains_text(again.err, "[1/2]"));
  REQUIRE(write_file(folder / "wrong.jsonl", "{\"id\": 3}\n"));
  const auto wrong = run({"experiment", "--programs", folder / "wrong.jsonl", "-o", folder / "out2"});
  CHECK(wrong.code == 1);
  CHECK(contains_text(wrong.err, "line 1"));
}
