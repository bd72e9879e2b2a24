#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

class Drawn {
 public:
  Drawn() { REQUIRE(write_file(folder / "scene.json", dump_json(to_json(test::furnished_room())))); }

  auto render(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"render",   folder / "scene.json",   "--cache", folder / "cache",
                                          "--pixels", "64", "--no-default-libraries"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  bool has(const std::string& file) const { return std::filesystem::exists(folder.path() / file); }

  TemporaryFolder folder;
};

}  // namespace

TEST_CASE("Layers of several views, and of cameras of a file, go into one folder") {
  const Drawn drawn;
  REQUIRE(drawn.render({"--layers", "--view", "top,eye", "-o", drawn.folder / "shots"}).code == 0);
  for (const std::string name : {"top", "eye"})
    for (const std::string end : {".png", ".depth.png", ".normals.png", ".instances.png", ".categories.png", ".json"})
      CHECK(drawn.has("shots/" + name + end));
  REQUIRE(write_file(drawn.folder / "cameras.json", R"({"cameras": [
      {"name": "corner", "eye": [0.5, 0.5, 1.6], "target": [3, 2, 0.5], "width": 64, "height": 48}]})"));
  const auto file = drawn.folder / "cameras.json";
  REQUIRE(drawn.render({"--layers", "--cameras", file, "-o", drawn.folder / "shots"}).code == 0);
  CHECK(drawn.has("shots/corner.depth.png"));
  CHECK(drawn.has("shots/top.depth.png"));
}

TEST_CASE("What layers cannot be made of is refused before anything is written") {
  const Drawn drawn;
  CHECK(drawn.render({"--view", "top,eye"}).code == 2);
  CHECK(drawn.render({"--alone"}).code == 2);
  CHECK(drawn.render({"--layers", "--marks"}).code == 2);
  CHECK(drawn.render({"--layers", "--view", "segments"}).code == 2);
  CHECK(drawn.render({"--layers", "--view", "sideways"}).code == 2);
  REQUIRE(write_file(drawn.folder / "cameras.json",
                     R"({"cameras": [{"name": "a", "eye": [1, 1], "target": [2, 1, 1]}]})"));
  const auto refused =
      drawn.render({"--layers", "--cameras", drawn.folder / "cameras.json", "-o", drawn.folder / "none"});
  CHECK(refused.code == 1);
  CHECK(contains_text(refused.err, "/cameras/0/eye"));
  CHECK_FALSE(drawn.has("none"));
}

TEST_CASE("A picture of segments is one file") {
  const Drawn drawn;
  CHECK(drawn.render({"--view", "segments", "-o", drawn.folder / "segments.png"}).code == 0);
  CHECK(drawn.has("segments.png"));
}
