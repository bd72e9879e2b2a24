#include <nlohmann/json.hpp>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"
#include "support/random_problem.h"

using namespace roomgen;

namespace {

Object random_object(Random& random, int number) {
  Object o = rooms::thing("thing-" + std::to_string(number), "office chair",
                          {random.uniform(0.1, 3), random.uniform(0.1, 3), random.uniform(0.1, 3)},
                          shapes::random_point(random, -5, 5), random.uniform(-500, 500));
  o.position.z() = random.chance(0.5) ? 0.0 : random.uniform(0, 2);
  o.description = "a \"nice\" thing, äöü";
  o.traits = {random.chance(0.5), random.chance(0.5), random.chance(0.5)};
  o.mount = static_cast<Mount>(random.integer(0, 3));
  o.on = number > 0 && o.mount == Mount::surface ? "thing-0" : "";
  if (number == 0) o.mount = Mount::floor;
  o.locked = random.chance(0.5);
  o.relations = {{RelationKind::edge, ""}, {RelationKind::near, "wall-1"}};
  if (random.chance(0.3)) o.asset = {"lib", "id/1", "abc", "CC-BY-4.0", "somebody", std::nullopt};
  else if (random.chance(0.3))
    o.asset.procedural = ProceduralSource{"table", R"({"legs":4,"top":"oak"})", 12345};
  return o;
}

Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene = rooms::scene(rooms::random_room(random), {});
  scene.prompt = "a room\nfor \"two\"";
  scene.seed = seed;
  scene.incomplete = random.chance(0.5);
  if (random.chance(0.5)) scene.room.materials = {"oak", "white", ""};
  for (int i = 0; i < 6; ++i) scene.objects.push_back(random_object(random, i));
  scene.unplaced = {{"sofa-9", "sofa", "no place"}};
  return scene;
}

Result<Scene> through_text(const Scene& scene) {
  const auto json = parse_json(dump_json(to_json(scene)), "scene.json");
  REQUIRE(json);
  return scene_from_json(*json, "scene.json");
}

}  // namespace

TEST_CASE("A scene that is written and read has the same bytes when written again") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scene scene = random_scene(seed);
    const auto again = through_text(scene);
    INFO("seed " << seed << ": " << (again ? "" : again.error().message));
    REQUIRE(again);
    REQUIRE(dump_json(to_json(*again)) == dump_json(to_json(scene)));
  }
}

TEST_CASE("Everything in a scene comes back as it was, poses to a tenth of a millimetre") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Scene scene = random_scene(seed);
    const auto again = through_text(scene);
    REQUIRE(again);
    CHECK(again->prompt == scene.prompt);
    CHECK(again->seed == scene.seed);
    CHECK(again->incomplete == scene.incomplete);
    CHECK(again->room.materials.floor == scene.room.materials.floor);
    REQUIRE(again->room.openings.size() == scene.room.openings.size());
    REQUIRE(again->objects.size() == scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const Object &a = scene.objects[i], &b = again->objects[i];
      CHECK(a.id == b.id);
      CHECK(a.description == b.description);
      CHECK(a.asset == b.asset);
      CHECK(a.traits == b.traits);
      CHECK((a.size - b.size).cwiseAbs().maxCoeff() < 0.51e-4);
      CHECK((a.position - b.position).cwiseAbs().maxCoeff() < 0.51e-4);
      CHECK(std::abs(wrap_angle(a.yaw - b.yaw)) < radians(0.00051));
      CHECK(a.mount == b.mount);
      CHECK(a.on == b.on);
      CHECK(a.relations == b.relations);
      CHECK(a.locked == b.locked);
    }
    CHECK(again->unplaced.at(0).reason == "no place");
  }
}

TEST_CASE("A rounded pose is what a file holds, and rounding again changes nothing") {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Object once = with_rounded_pose(random_object(random, i));
    const Object twice = with_rounded_pose(once);
    REQUIRE(once.position == twice.position);
    REQUIRE(once.yaw == twice.yaw);
    REQUIRE(to_json(rooms::scene(rooms::box(4, 4), {once}))["objects"][0]["yaw_deg"] ==
            rounded(degrees(once.yaw), 3));
  }
}

TEST_CASE("Objects of one asset have one key, and other assets another") {
  AssetRef box;
  CHECK(box.is_box());
  CHECK(asset_key(box).empty());
  AssetRef a{"lib", "chair", "", "", "", std::nullopt}, b{"lib", "table", "", "", "", std::nullopt};
  AssetRef other_library{"bib", "chair", "", "", "", std::nullopt};
  CHECK(asset_key(a) != asset_key(b));
  CHECK(asset_key(a) != asset_key(other_library));
  AssetRef p, q;
  p.procedural = ProceduralSource{"table", R"({"legs":4})", 1};
  q.procedural = ProceduralSource{"table", R"({"legs":4})", 2};
  CHECK(asset_key(p) != asset_key(q));
  q.procedural->seed = 1;
  CHECK(asset_key(p) == asset_key(q));
}
