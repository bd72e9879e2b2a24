#include "roomgen/kinds/kind_table.h"

#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

constexpr const char* furniture = R"({"kinds": {
  "seat": {"size": [0.6, 0.6, 0.8], "zones": [{"side": "front", "depth": 0.4, "partners": ["tables"]}],
           "gaps": {"table": [0, 0.1]}},
  "armchair": {"is": "chair", "size": [0.8, 0.8, 0.9]},
  "chair": {"is": "seat", "names": ["side chair"], "tucks_under": ["table"]},
  "table": {"size": [1.2, 0.8, 0.75], "traits": ["round"]},
  "coffee table": {"is": "table", "zones": []},
  "box shelf": {}}})";

std::string complaint(const std::string& text) {
  const auto table = KindTable::parse(text, "c.json");
  if (table) return "";
  CHECK(is_one_line(table.error().message));
  return table.error().message;
}

}  // namespace

TEST_CASE("A category inherits what it does not say, whatever the order in the file") {
  const auto table = KindTable::parse(furniture, "c.json");
  REQUIRE(table);
  const Kind& armchair = table->get("armchair");
  CHECK(armchair.size == Vec3(0.8, 0.8, 0.9));
  CHECK(armchair.lineage.size() == 3);
  REQUIRE(armchair.zones.size() == 1);
  CHECK(armchair.zones[0].partners == std::vector<std::string>{"table"});
  CHECK(armchair.tucks_under == std::vector<std::string>{"table"});
  CHECK(table->get("chair").size == Vec3(0.6, 0.6, 0.8));
  CHECK(table->get("coffee table").traits.round);
  CHECK(table->get("coffee table").zones.empty());
}

TEST_CASE("A name is looked up as it is, as a synonym, in the plural, and by its ending") {
  const auto table = KindTable::parse(furniture, "c.json");
  REQUIRE(table);
  const auto found = [&](const char* name) {
    const Kind* category = table->find(name);
    return category ? category->name : "";
  };
  CHECK(found("chair") == "chair");
  CHECK(found("Side Chair") == "chair");
  CHECK(found("side-chairs") == "chair");
  CHECK(found("old oak coffee table") == "coffee table");
  CHECK(found("box shelves") == "box shelf");
  CHECK(found("chair lift").empty());  // a lift, not a chair
  CHECK(found("").empty());
  CHECK(found("  - ").empty());
  CHECK(found(std::string(100000, 'x').c_str()).empty());
}

TEST_CASE("A variant is built and held under its own name, and planned as its parent") {
  const auto table = KindTable::parse(R"({"kinds": {
    "wardrobe": {"size": [1.2, 0.6, 2.0], "loose_names": ["closet"]},
    "armoire": {"is": "wardrobe", "variant": true, "names": ["clothes armoire"]},
    "amplifier": {"is": "stereo", "variant": true, "stocked_as": "amplifier", "built_as": "stereo"},
    "stereo": {}}})", "k.json");
  REQUIRE(table);
  CHECK(table->find("old clothes armoires")->name == "wardrobe");
  const Kind* armoire = table->named("clothes armoire");
  REQUIRE(armoire);
  CHECK(armoire->name == "armoire");
  CHECK(armoire->stocked_as == "wardrobe");
  CHECK(armoire->built_as == "armoire");
  CHECK(table->planned(*armoire).name == "wardrobe");
  CHECK(table->named("amplifier")->stocked_as == "amplifier");
  CHECK(table->named("amplifier")->built_as == "stereo");
  CHECK(table->named("closets")->name == "wardrobe");
  CHECK_FALSE(table->called("closets"));
  CHECK(table->spelled("closet")->name == "wardrobe");
  CHECK_FALSE(table->spelled("closets"));
}

TEST_CASE("What hangs otherwise than its parent needs none of its floor, and hangs at the height of eyes") {
  const auto table = KindTable::parse(R"({"kinds": {
    "screen": {"size": [1, 0.1, 0.6], "zones": [{"side": "front", "depth": 1}]},
    "wall screen": {"is": "screen", "mount": "wall"}}})", "k.json");
  REQUIRE(table);
  CHECK(table->get("wall screen").zones.empty());
  CHECK(table->get("wall screen").elevation == Approx(1.2));
  CHECK(table->get("screen").zones.size() == 1);
}

TEST_CASE("A table of several files is one table, and copies of it live by themselves") {
  const std::vector<KindFile> files = {{R"({"kinds": {"arm chair": {"is": "seat"}}})", "a.json"},
                                       {R"({"kinds": {"seat": {"size": [1, 1, 1]}}})", "b.json"}};
  KindTable copy;
  {
    const auto table = KindTable::read(files);
    REQUIRE(table);
    copy = *table;
  }
  CHECK(copy.get("arm chairs").size == Vec3(1, 1, 1));
  const std::vector<KindFile> twice = {files[1], files[1]};
  const auto refused = KindTable::read(twice);
  REQUIRE_FALSE(refused);
  CHECK(contains_text(refused.error().message, "/kinds/seat"));
}

TEST_CASE("Kinship goes up the line and not down or sideways") {
  const auto table = KindTable::parse(furniture, "c.json");
  REQUIRE(table);
  CHECK(table->is_a("armchair", "seat"));
  CHECK(table->is_a("armchairs", "chair"));
  CHECK(table->is_a("chair", "chair"));
  CHECK_FALSE(table->is_a("chair", "armchair"));
  CHECK_FALSE(table->is_a("table", "seat"));
  CHECK_FALSE(table->is_a("spaceship", "seat"));
  CHECK(table->is_any_of("armchair", {"table", "seat"}));
  CHECK_FALSE(table->is_any_of("armchair", {}));
}

TEST_CASE("What means nothing is a thing without zones") {
  const auto table = KindTable::parse(furniture, "c.json");
  REQUIRE(table);
  CHECK(table->get("spaceship").zones.empty());
  CHECK(table->get("spaceship").lineage.empty());
}

TEST_CASE("Mistakes in the table are located") {
  CHECK(contains_text(complaint("{"), "c.json: not valid JSON"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"is": "b"}}})"), "/kinds/a/is"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"is": "b"}, "b": {"is": "a"}}})"), "circle"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"sise": [1,1,1]}}})"), "did you mean \"size\"?"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"zones": [{"side": "top", "depth": 1}]}}})"),
                      "/kinds/a/zones/0/side"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"built_as": "nothing"}}})"), "nothing"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"variant": true}}})"), "/kinds/a"));
  CHECK(contains_text(complaint(R"({"kinds": {"a": {"tucks_under": ["nothing"]}}})"), "nothing"));
}

TEST_CASE("A zone lies along the whole of its side, in the object's own sense of left and right") {
  //          back
  //        +------+        At yaw 0 the front looks down, and the object's left is the +X side:
  //  right |  v   | left   the left hand of someone who sits in it.
  //        +------+
  //         front
  const Footprint object({0, 0}, {2, 1}, 0.0);
  const auto center = [&](Side side) { return zone_footprint(object, {side, 0.6, {}}).center(); };
  CHECK((center(Side::front) - Vec2(0, -0.8)).norm() < 1e-12);
  CHECK((center(Side::back) - Vec2(0, 0.8)).norm() < 1e-12);
  CHECK((center(Side::left) - Vec2(1.3, 0)).norm() < 1e-12);
  CHECK((center(Side::right) - Vec2(-1.3, 0)).norm() < 1e-12);
  for (int degree = 0; degree < 360; degree += 15)
    for (Side side : {Side::front, Side::back, Side::left, Side::right}) {
      const Footprint turned({3, -2}, {2, 1}, radians(degree));
      const Footprint zone = zone_footprint(turned, {side, 0.6, {}});
      const bool ends = side == Side::left || side == Side::right;
      CHECK(zone.area() == Approx(0.6 * (ends ? 1.0 : 2.0)));
      CHECK(gap(turned, zone) == Approx(0.0).margin(1e-9));
      CHECK_FALSE(overlaps(turned, zone));
      CHECK((turned.to_local(zone.center()) - center(side)).norm() < 1e-9);
    }
}

TEST_CASE("Who lies in a bed gets in at its long sides, and not at its head") {
  const UseZone left{Side::left, 0.5, {}, 0.6, true};
  const Footprint zone = zone_footprint(Footprint({0, 0}, {1.6, 2.0}, 0.0), left);
  CHECK((zone.center() - Vec2(1.05, -0.3)).norm() < 1e-12);
  CHECK(zone.area() == Approx(0.5 * 1.4));
  const Footprint along = zone_footprint(Footprint({0, 0}, {2.5, 1.1}, 0.0), left);
  CHECK((along.center() - Vec2(0, -0.8)).norm() < 1e-12);
  CHECK(along.area() == Approx(0.5 * 2.5));
}
