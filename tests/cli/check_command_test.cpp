#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/export/exporter.h"
#include "support/contains.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

// A crate under a table: apart by their meshes, not by their boxes.
Scene crate_under_table(ModelTable& models) {
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("table-0", {1.2, 0.8, 0.75}, {2, 1.8, 0}), test::box("crate-0", {0.4, 0.4, 0.4}, {2, 1.8, 0})};
  Model table = test::colored_box({1.2, 0.8, 0.75}, {120, 80, 40});
  table.parts = {{make_box({-0.6, -0.4, 0.7}, {0.6, 0.4, 0.75}), 0}, {make_box({-0.6, -0.4, 0}, {-0.55, -0.35, 0.7}), 0}};
  test::use_model(scene.objects[0], models, "table", std::move(table));
  return scene;
}

}  // namespace

TEST_CASE("A scene without its furniture library is checked by the meshes beside it") {
  const TemporaryFolder folder;
  ModelTable models;
  const Scene scene = crate_under_table(models);
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(scene))));
  const auto overlaps = [&] {
    const auto ended = run({"check", folder / "scene.json", "--no-default-libraries", "--cache", folder / "cache"});
    return ended.out.find("overlap") != std::string::npos;
  };
  CHECK(overlaps());
  REQUIRE(GlbExporter().write(scene, models, folder / "scene.glb"));
  CHECK_FALSE(overlaps());
}

TEST_CASE("A program is checked, and said in words") {
  const TemporaryFolder folder;
  const std::string program = ROOMGEN_SOURCE_DIR "/examples/programs/kitchen.json";
  const auto sound = run({"check", program});
  CHECK(sound.code == 0);
  CHECK(sound.out.find("sound program of 9 sets, 4 constraints and 3 scores") != std::string::npos);
  CHECK(sound.out.find("eating: the number of table is from 0 to 1 and (for every t in table:") != std::string::npos);

  // Without a format, and with a tag that nobody knows.
  const auto wrong = (folder / "wrong.json").string();
  REQUIRE(write_file(wrong, R"({"room": {"type": "kitchen"}, "sets": {"a": {"tags": ["storige"]}},
    "constraints": {"n": ["in", ["count", "a"], 1, 2]}})"));
  const auto refused = run({"check", wrong});
  CHECK(refused.code == 1);
  CHECK(refused.out.find("error: /sets/a: \"storige\" is no tag; did you mean \"storage\"?") != std::string::npos);
  const auto json = parse_json(run({"--json", "check", wrong}).out, "output");
  REQUIRE(json);
  CHECK((*json)["errors"] == 1);
  CHECK((*json)["findings"][0]["at"] == "/sets/a");
  REQUIRE(write_file(wrong, R"({"room": {"type": "kitchen"}, "sets": {}, "constraints": {"n": ["in", 1]}})"));
  CHECK(failed_in_one_line(run({"check", wrong}), 1));
}

TEST_CASE("Names of a stranger's scene do not steer the terminal") {
  const TemporaryFolder folder;
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("table\x1b[31m-0", {1.2, 0.8, 0.75}, {2, 1.8, 0}), test::box("crate\x07-0", {0.4, 0.4, 0.4}, {2, 1.8, 0})};
  for (auto& object : scene.objects) {
    object.asset.library = "gone\x1b]0;title\x07";
    object.asset.id = "chair\x1b[2J";
  }
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(scene))));
  const std::string file = folder / "scene.json";
  for (const auto& arguments : {std::vector<std::string>{"check", file}, {"export", file, "--format", "glb", "-o", folder / "room.glb"},
                                {"render", file, "--view", "top", "-o", folder / "top.png"}}) {
    auto with_library = arguments;
    with_library.insert(with_library.end(), {"--no-default-libraries", "--cache", folder / "cache"});
    const auto ended = run(with_library);
    INFO(arguments.front() << "\n" << ended.err << ended.out);
    CHECK(contains_text(ended.err, "gone?]0;title?"));
    CHECK(ended.err.find_first_of("\x1b\x07") == std::string::npos);
    CHECK(ended.out.find_first_of("\x1b\x07") == std::string::npos);
  }
}
