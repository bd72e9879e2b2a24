#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

namespace {

// The summary on stdout; the test stops if it is no JSON object.
roomgen::Json summary(const Ended& ended) {
  INFO(ended.out);
  const auto json = roomgen::parse_json(ended.out, "stdout");
  REQUIRE(json);
  REQUIRE(json->is_object());
  return *json;
}

}  // namespace

TEST_CASE("The summary of a solve parses, and counts") {
  const TemporaryFolder folder;
  const auto json = summary(run({"solve", test_data + "/rooms/90-too-large.json", "-o", folder / "a.json", "--json"}));
  CHECK(json["objects"] == 2);
  CHECK(json["unplaced"] == 1);
  CHECK(json["constraints"] == 4);
  CHECK(json["output"] == (folder / "a.json").string());
}

TEST_CASE("The summary of a check parses for every kind of file") {
  const TemporaryFolder folder;
  REQUIRE(run({"solve", test_data + "/solver-scenes/balcony.json", "-o", folder / "scene.json"}).code == 0);
  const auto scene = summary(run({"check", folder / "scene.json", "--json"}));
  CHECK(scene["format"] == "roomgen-scene");
  CHECK(scene["violations"].empty());

  summary(run({"check", test_data + "/solver-scenes/balcony.json", "--json"}));

  const std::string room = R"({"type": "x", "polygon": [[0,0],[4,0],[4,4],[0,4]]})";
  REQUIRE(roomgen::write_file(folder / "room.json", room));
  summary(run({"check", folder / "room.json", "--json"}));

  REQUIRE(roomgen::write_file(folder / "plan.json",
                              R"({"format": "roomgen-plan", "version": 1, "room": )" + room +
                                  R"(, "objects": [{"category": "bed"}]})"));
  summary(run({"check", folder / "plan.json", "--json"}));
}
