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
struct OptimiseFolder {
  TemporaryFolder folder;

  Ended optimise(const std::string& program, std::vector<std::string> more = {}) const {
    REQUIRE(write_file(folder / "program.json", program));
    std::vector<std::string> arguments = {"optimise", folder / "program.json",  "-o",     folder / "room",
                                          "--cache",  folder / "cache",         "--no-default-libraries",
                                          "--no-pictures", "--force", "--steps", "1500", "--assets", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

std::string desks(const std::string& bound, const std::string& room = R"("width": 4, "depth": 4)") {
  return R"({"format": "roomgen-program", "room": {"type": "study", )" + room + R"(},
    "sets": {"desk": {"factory": "desk", "rel": [["on_floor", "room"], ["against_wall", "room"]]}},
    "constraints": {"desks": )" + bound + R"(}, "scores": {}})";
}

}  // namespace

TEST_CASE("A program becomes a folder with the verdict on each constraint") {
  const OptimiseFolder shop;
  const auto done = shop.optimise(desks(R"(["==", ["count", "desk"], 2])"), {"--seed", "3"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(contains_text(done.out, "1 of 1 constraints held"));
  for (const char* name : {"scene.json", "program.json", "optimise.json", "scene.glb", "ATTRIBUTION.md"})
    CHECK(std::filesystem::exists(shop.folder / (std::string("room/") + name)));
  const auto scene = parse_json(*read_file(shop.folder / "room/scene.json"), "scene.json");
  CHECK((*scene)["program"] == Json::parse(R"([{"name": "desks", "held": true, "amount": 0.0}])"));
  CHECK((*scene)["objects"].size() == 2);
  for (const auto& object : (*scene)["objects"]) CHECK(object["relations"] == Json::parse(R"(["edge"])"));
  CHECK(run({"check", shop.folder / "room/scene.json"}).code == 0);
  CHECK(run({"check", shop.folder / "room/program.json"}).code == 0);
  const std::string first = *read_file(shop.folder / "room/scene.json");
  CHECK(shop.optimise(desks(R"(["==", ["count", "desk"], 2])"), {"--seed", "3"}).code == 0);
  CHECK(*read_file(shop.folder / "room/scene.json") == first);
}

TEST_CASE("What cannot be met is said, and strictness makes it a failure") {
  const OptimiseFolder shop;
  const std::string crowded = desks(R"(["==", ["count", "desk"], 5])", R"("width": 2, "depth": 2.4)");
  const auto lenient = shop.optimise(crowded);
  INFO(lenient.err << lenient.out);
  if (lenient.code == 0) {
    CHECK(contains_text(lenient.out, "desks is missed by"));
    CHECK(shop.optimise(crowded, {"--strict"}).code == 1);
  } else {
    CHECK(contains_text(lenient.err, "m2 of floor"));
  }
}

TEST_CASE("Unsound programs are refused with their place") {
  const OptimiseFolder shop;
  const auto unknown = shop.optimise(desks(R"(["==", ["count", "dseks"], 2])"));
  CHECK(unknown.code == 1);
  CHECK(contains_text(unknown.err, "/constraints/desks/1"));
  const auto broken = shop.optimise("{\"room\": ");
  CHECK(broken.code == 1);
  CHECK_FALSE(std::filesystem::exists(shop.folder / "room/scene.json"));
  CHECK(run({"optimise", shop.folder / "none.json"}).code == 1);
  CHECK(shop.optimise(desks(R"(["==", ["count", "desk"], 2])"), {"--steps", "0"}).code == 2);
}
