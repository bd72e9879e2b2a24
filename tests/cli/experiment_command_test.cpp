#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

namespace {

using roomgen::Json;

constexpr const char* suite = R"([
 {"prompt": "a stool with three legs", "group": "common", "kind": "stool",
  "parts": [{"label": "seat", "count": 1}, {"label": "leg", "count": 3}],
  "size": [[0.2, 0.7], [0.2, 0.7], [0.3, 0.9]], "mount": "floor"},
 {"prompt": "a fast red racing car", "group": "strange", "kind": "car", "parts": [{"label": "wheel", "count": 4}],
  "size": [[1, 5], [1, 5], [1, 3]], "mount": "floor"}
])";

class Suite {
 public:
  Suite() { REQUIRE(roomgen::write_file(folder_ / "suite.json", suite)); }

  Ended run(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"experiment", "--create", folder_ / "suite.json", "-o",
                                          folder_ / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ::run(arguments);
  }
  std::string text(const std::string& name) const {
    const auto text = roomgen::read_file(path(name));
    INFO(name);
    REQUIRE(text);
    return *text;
  }
  Json json(const std::string& name) const {
    const auto json = roomgen::parse_json(text(name), name);
    REQUIRE(json);
    return *json;
  }
  std::string path(const std::string& name) const { return (folder_ / "out").string() + "/" + name; }

 private:
  TemporaryFolder folder_;
};

bool is_built() {
  return contains_text(run({"--help"}).out, "experiment");
}

}  // namespace

TEST_CASE("experiment scores each variant and leaves what score.py reads") {
  if (!is_built()) return;
  const Suite suite;
  const auto ended = suite.run({"--variants", "full,no-validation", "--json"});
  INFO(ended.err);
  REQUIRE(ended.code == 0);
  const auto figures = roomgen::parse_json(ended.out, "stdout");
  REQUIRE(figures);
  for (const char* variant : {"full", "no-validation"}) {
    const Json& all = (*figures)[variant]["all"];
    CHECK(all["made"] == Json{{"right", 1}, {"of", 2}});
    CHECK(all["parts_right"] == Json{{"right", 2}, {"of", 3}});
    CHECK((*figures)[variant]["strange"]["everything"]["right"] == 0);
    const std::string base = variant;
    CHECK(suite.text(base + "/001.glb").substr(0, 4) == "glTF");
    CHECK(suite.json(base + "/001.json")["format"] == "roomgen-shape");
    CHECK(suite.json(base + "/001.summary.json")["bodies"].size() >= 4);
    CHECK(suite.json(base + "/002.result.json")["exit"] == 1);
    CHECK(contains_text(suite.text("report.md"), "score.py " + suite.path(base)));
  }
  CHECK(suite.json("results.json")["results"].size() == 4);
  CHECK(contains_text(suite.text("report.md"), "a fast red racing car: not made: "));
}

TEST_CASE("An experiment that was stopped goes on, and only where it is the same") {
  if (!is_built()) return;
  const Suite suite;
  REQUIRE(suite.run({"--quiet"}).code == 0);
  const std::string whole = suite.text("results.jsonl");
  const auto last = whole.rfind("{\"variant\"");
  REQUIRE(last != std::string::npos);

  // Killed within its last line: that object is made again, the first is not.
  std::string mark = whole.substr(0, last + 20);
  const std::string prompt = "a stool with three legs";
  mark.replace(mark.find(prompt), prompt.size(), "a thing made before");
  REQUIRE(roomgen::write_file(suite.path("results.jsonl"), mark));
  const auto again = suite.run({});
  INFO(again.err);
  REQUIRE(again.code == 0);
  CHECK(contains_text(again.err, "[2/2]"));
  CHECK_FALSE(contains_text(again.err, "[1/2]"));
  const Json results = suite.json("results.json")["results"];
  REQUIRE(results.size() == 2);
  CHECK(results[0]["prompt"] == "a thing made before");

  const auto other = suite.run({"--seed", "7"});
  CHECK(failed_in_one_line(other, 1));
  CHECK(contains_text(other.err, "another experiment"));
  CHECK(suite.run({"--seed", "7", "--force", "--quiet"}).code == 0);
  CHECK(suite.json("results.json")["results"][0]["prompt"] == prompt);
}

TEST_CASE("experiment refuses what it cannot do") {
  if (!is_built()) return;
  const Suite suite;
  CHECK(failed_in_one_line(suite.run({"--variants", "best"}), 2));
  CHECK(failed_in_one_line(suite.run({"--variants", "direct"}), 2));
  CHECK(failed_in_one_line(run({"experiment", "-o", suite.path("x")}), 2));
  CHECK(failed_in_one_line(run({"experiment", "--create", "none.json", "-o", suite.path("x")}), 1));
  CHECK(contains_text(suite.run({"--judge"}).err, "--judge"));
  REQUIRE(roomgen::make_folder(suite.path("")));
  REQUIRE(roomgen::write_file(suite.path("letter.txt"), "mine"));
  const auto ended = suite.run({});
  CHECK(failed_in_one_line(ended, 1));
  CHECK(contains_text(ended.err, "--force"));
  CHECK(suite.text("letter.txt") == "mine");
}
