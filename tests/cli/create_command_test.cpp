#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/contains.h"

namespace {

const std::string shapes = ROOMGEN_TEST_DATA "/shapes/";

std::string bytes(const std::string& path) {
  const auto text = roomgen::read_file(path);
  INFO(path);
  REQUIRE(text);
  return *text;
}

}  // namespace

TEST_CASE("create writes a GLB and the concrete program, the same for the same seed") {
  const TemporaryFolder folder;
  const auto create = [&](const std::string& name, const std::string& seed) {
    const auto ended =
        run({"create", "--program", shapes + "bookshelf.json", "-o", folder / (name + ".glb"),
             "--seed", seed, "--write-program", folder / (name + ".json"), "--json"});
    INFO(ended.err);
    REQUIRE(ended.code == 0);
    const auto json = roomgen::parse_json(ended.out, "stdout");
    REQUIRE(json);
    CHECK((*json)["size"] == roomgen::Json({0.9, 0.3, 1.9}));
    CHECK((*json)["output"] == (folder / (name + ".glb")).string());
  };
  create("a", "5");
  create("b", "5");
  create("c", "6");
  CHECK(bytes(folder / "a.glb").substr(0, 4) == "glTF");
  CHECK(bytes(folder / "a.glb") == bytes(folder / "b.glb"));
  CHECK(bytes(folder / "a.json") == bytes(folder / "b.json"));
  CHECK(bytes(folder / "a.json") != bytes(folder / "c.json"));

  const auto again = run({"create", "--program", folder / "a.json", "-o", folder / "d.glb"});
  CHECK(again.code == 0);
  CHECK(bytes(folder / "d.glb") == bytes(folder / "a.glb"));
}

TEST_CASE("create sets parameters and finds the recipes beside the file") {
  const TemporaryFolder folder;
  const auto ended =
      run({"create", "--program", shapes + "chair.json", "--set", "legs=turned", "--set", "slats=0",
           "--set", "height=1", "--write-program", folder / "a.json", "--json"});
  INFO(ended.err);
  REQUIRE(ended.code == 0);
  CHECK(contains_text(bytes(folder / "a.json"), "turned"));
  CHECK_FALSE(contains_text(bytes(folder / "a.json"), "\"slat"));
}

TEST_CASE("create refuses wrong values in one line and writes nothing") {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<std::string> more, int code) {
    std::vector<std::string> arguments = {"create", "--program", shapes + "vase.json", "-o",
                                          folder / "a.glb"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ended = run(arguments);
    INFO(ended.err);
    CHECK(failed_in_one_line(ended, code));
    CHECK(names_in(folder.path()).empty());
    return ended.err;
  };
  CHECK(contains_text(refused({"--set", "width=2"}, 1),
                      "\"width\": 2 is out of range; expected a number from 0.06 to 0.5"));
  CHECK(contains_text(refused({"--set", "width=wide"}, 1), "is no number"));
  CHECK(contains_text(refused({"--set", "widht=0.1"}, 1), "did you mean \"width\"?"));
  CHECK(contains_text(refused({"--set", "color=dark"}, 1), "no colour"));
  refused({"--set", "width"}, 2);
  refused({"--set", "=1"}, 2);
  refused({"--tolerance", "0"}, 2);
  refused({"--seed", "-1"}, 2);
  CHECK(failed_in_one_line(run({"create", "--program", shapes + "vase.json"}), 2));
  CHECK(failed_in_one_line(run({"create", "-o", folder / "a.glb"}), 2));
  CHECK(failed_in_one_line(
      run({"create", "--program", folder / "none.json", "-o", folder / "a.glb"}), 1));
  CHECK(failed_in_one_line(
      run({"create", "--program", shapes + "vase.json", "-o", (folder / "no") / "a.glb"}), 1));
}

TEST_CASE("create draws views where the program was built with a renderer") {
  if (!contains_text(run({"create", "--help"}).out, "--views")) return;
  const TemporaryFolder folder;
  const auto ended =
      run({"create", "--program", shapes + "bar-stool.json", "--views", folder / "views"});
  INFO(ended.err);
  REQUIRE(ended.code == 0);
  CHECK(names_in(folder / "views") ==
        std::vector<std::string>{"above.png", "back.png", "front.png", "side.png", "views.png"});
}

TEST_CASE("check accepts shapes and says where one is wrong") {
  const TemporaryFolder folder;
  for (const char* name :
       {"bar-stool", "bookshelf", "chair", "floor-lamp", "leg", "sofa", "vase"}) {
    const auto ended = run({"check", shapes + name + ".json"});
    INFO(ended.err);
    CHECK(ended.code == 0);
    CHECK(contains_text(ended.out, "sound shape of"));
  }
  REQUIRE(roomgen::write_file(
      folder / "a.json",
      R"({"format": "roomgen-shape", "version": 1, "components": [{"name": "a", "box": {"size": [1, 1, "w"]}}]})"));
  const auto ended = run({"check", folder / "a.json"});
  CHECK(failed_in_one_line(ended, 1));
  CHECK(contains_text(ended.err, "/components/0/box/size/2: \"w\": column 1: unknown name \"w\""));
}
