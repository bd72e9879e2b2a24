// Doors and windows of the furniture packages, and what a library may say of them.
#include <algorithm>
#include <map>

#include "catch.h"
#include "fixture.h"
#include "geometry/outline.h"
#include "roomgen/geometry/polygon.h"
#include "scene/opening_kind.h"

using namespace roomgen;
using namespace roomgen::assets;

namespace {

// A library of one cube that is a door, with these further properties.
Result<AssetInfo> door(const std::string& properties, std::string* warning = nullptr) {
  TemporaryFolder folder;
  const std::string catalogue =
      "name#1=Door\nid#1=door\nmodel#1=cube.obj\nwidth#1=90\ndepth#1=20\nheight#1="
      "210\ndoorOrWindow#1=true\n" +
      properties +
      "name#2=Chair\nid#2=chair\nmodel#2=cube.obj\nwidth#2=50\ndepth#2=50\nheight#2="
      "90\ndoorOrWindow#2=false\n";
  write_zip(folder.path() / "Doors.sh3f",
            {{"PluginFurnitureCatalog.properties", catalogue}, {"cube.obj", cube_obj()}});
  CatalogueOptions options;
  options.libraries = {folder.path() / "Doors.sh3f"};
  options.cache_dir = folder.path() / "cache";
  options.log = [&](LogLevel, std::string_view message) {
    if (warning) *warning += message;
  };
  const auto catalogue_of_doors = open_catalogue(options);
  REQUIRE(catalogue_of_doors);
  CHECK_FALSE((*catalogue_of_doors)->find("chair")->wall_fit);
  return (*catalogue_of_doors)->find("door");
}

}  // namespace

TEST_CASE("A library says how a door sits in its wall, and the catalogue remembers it") {
  const auto info = door(
      "doorOrWindowWallThickness#1=7.5\ndoorOrWindowWallDistance#1=4\n"
      "doorOrWindowSashXAxis#1=8\ndoorOrWindowCutOutShape#1=M0,0.25 a0.5,0.25 0 0,1 1,0 v0.75 h-1 "
      "z\n");
  REQUIRE(info);
  REQUIRE(info->wall_fit);
  CHECK(info->wall_fit->wall_back == Approx(0.16));
  CHECK(info->wall_fit->wall_front == Approx(0.085));
  CHECK(info->wall_fit->leaves == 1);
  CHECK(info->wall_fit->hinge_left);
  CHECK(is_opening_outline(info->wall_fit->outline));
  const auto plain = door("");
  REQUIRE(plain->wall_fit);
  CHECK(plain->wall_fit->wall_front == Approx(0.0));
  CHECK(plain->wall_fit->wall_back == Approx(0.2));
  CHECK(plain->wall_fit->leaves == 0);
  CHECK(plain->wall_fit->outline.empty());
}

TEST_CASE("A door that can be in no wall is left out with a warning, and the rest stays") {
  for (const char* wrong :
       {"doorOrWindowCutOutShape#1=M0,0 h0.01 v1 z\n", "doorOrWindowCutOutShape#1=nonsense\n",
        "doorOrWindowWallDistance#1=30\n", "doorOrWindowWallThickness#1=0\n"}) {
    std::string warning;
    INFO(wrong);
    CHECK_FALSE(door(wrong, &warning));
    CHECK(warning.find("door") != std::string::npos);
  }
}

TEST_CASE("The packages' doors and windows fit walls, and every kind with meshes has some") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const auto all = catalogue->all();
  REQUIRE(all);
  std::map<std::string, int> by_tag;
  int arched = 0;
  for (const auto& asset : *all) {
    if (!asset.wall_fit) continue;
    INFO(asset.ref.id);
    CHECK(asset.wall_fit->wall_front >= 0.0);
    CHECK(asset.wall_fit->wall_back <= asset.size.y() + 1e-9);
    if (!asset.wall_fit->outline.empty()) {
      ++arched;
      CHECK(is_opening_outline(asset.wall_fit->outline));
      CHECK(signed_area(asset.wall_fit->outline) > 0.7);
    }
    for (const auto& tag : asset.tags) ++by_tag[tag];
  }
  CHECK(arched >= 3);
  for (const auto& [name, kind] : OpeningKinds::built_in()->all())
    for (const auto& word : kind.meshes) {
      INFO(name << ": " << word);
      CHECK(by_tag[word] > 0);
    }
  CHECK_FALSE(catalogue->find("leather_sofa")->wall_fit);
}
