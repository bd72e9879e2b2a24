#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/export/exporter.h"
#include "support/contains.h"
#include "support/furnished_room.h"

using namespace roomgen;

TEST_CASE("A scene is written in every format that the library knows") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.json", dump_json(to_json(test::furnished_room()))));
  const auto written = [&](const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"export",  folder / "scene.json", "-o", folder / file,
                                          "--cache", folder / "cache",      "--no-default-libraries"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  for (const auto& format : export_formats()) {
    const std::string name(format.name);
    INFO(name);
    CHECK(written("by-ending." + name).code == 0);
    CHECK(written("by-option", {"--format", name}).code == 0);
    CHECK(*read_file(folder / ("by-ending." + name)) == *read_file(folder / "by-option"));
    CHECK(contains_text(run({"export", "--help"}).out, format.about));
  }
  const auto refused = written("room.nonsense");
  CHECK(refused.code == 2);
  CHECK(contains_text(refused.err, "no format \"nonsense\""));
  CHECK(contains_text(refused.err, "known are glb"));
  CHECK(written("room").code == 2);
  CHECK_FALSE(std::filesystem::exists(folder / "room.nonsense"));
}
