#include <nlohmann/json.hpp>

#include "catch.h"
#include "process.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/export/exporter.h"
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
