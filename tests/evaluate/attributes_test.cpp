#include "evaluate/attributes.h"

#include "catch.h"
#include "library/attribute_words.h"
#include "roomgen/base/file.h"
#include "roomgen/evaluate/report.h"
#include "support/furnished_room.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

Mesh disc(double radius) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  const int count = 40;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    mesh.positions.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), 0).cast<float>());
  }
  for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({0, i + 1, (i + 1) % count + 1});
  return mesh;
}

KnownLooks plain(const std::string& kind, const Vec3& size) {
  KnownLooks looks;
  looks.identity.kind = kind;
  looks.identity.words = {kind};
  looks.size = looks.usual = size;
  return looks;
}

bool has(const KnownLooks& looks, const std::string& attribute) {
  return judge_attribute(looks, attribute).held;
}

ShownColor shown(const std::string& name, double share, float r, float g, float b) {
  return {name, share, {r, g, b}};
}

}  // namespace

TEST_CASE("The table of attributes is sound") {
  const auto text = read_file(std::string(ROOMGEN_SOURCE_DIR) + "/data/evaluate/attributes.json");
  REQUIRE(text);
  const auto table = AttributeWords::parse(*text, "attributes.json");
  if (!table) FAIL(table.error().message);
  // Colours are those that meshes are said to show.
  std::set<std::string> names;
  for (float r = 0; r <= 255; r += 15)
    for (float g = 0; g <= 255; g += 15)
      for (float b = 0; b <= 255; b += 15) names.insert(color_name(r, g, b));
  for (const auto& [word, meaning] : table->all())
    for (const auto& color : meaning.colors) {
      INFO(word << ": " << color);
      CHECK(names.count(color) == 1);
    }
}

TEST_CASE("A table with mistakes is refused") {
  const auto parse = [](const std::string& attribute) {
    return bool(AttributeWords::parse("{\"attributes\": {\"x\": " + attribute + "}}", "t"));
  };
  CHECK(parse(R"({"outlines": ["round"]})"));
  CHECK_FALSE(parse(R"({"outlines": ["roundish"]})"));
  CHECK_FALSE(parse(R"({"sizes": [{"weight": [1, 2]}]})"));
  CHECK_FALSE(parse(R"({"sizes": [{"height": [1]}]})"));
  CHECK_FALSE(parse(R"({"colour": ["red"]})"));
  CHECK_FALSE(parse(R"({"mounts": ["sky"]})"));
  CHECK_FALSE(parse(R"("y")"));
}

TEST_CASE("Measured colours decide, whatever the label says") {
  KnownLooks desk = plain("desk", {1.2, 0.6, 0.75});
  desk.identity.words.insert("black");
  desk.colors = {shown("white", 0.8, 250, 250, 250), shown("black", 0.2, 10, 10, 10)};
  CHECK(has(desk, "white"));
  CHECK_FALSE(has(desk, "black"));
  desk.colors = {shown("white", 0.6, 250, 250, 250), shown("black", 0.4, 10, 10, 10)};
  CHECK(has(desk, "black"));
  desk.roughness = 0.8;
  CHECK(has(desk, "matte_black"));
  desk.roughness = 0.1;
  CHECK_FALSE(has(desk, "matte_black"));
}

TEST_CASE("Shades are read off the mean colour") {
  KnownLooks sofa = plain("sofa", {2, 0.9, 0.8});
  sofa.colors = {shown("blue", 0.9, 20, 30, 80)};
  CHECK(has(sofa, "navy_blue"));
  CHECK_FALSE(has(sofa, "light_blue"));
  sofa.colors = {shown("blue", 0.9, 150, 190, 240)};
  CHECK_FALSE(has(sofa, "navy"));
  CHECK(has(sofa, "sky_blue"));
}

TEST_CASE("A material is believed of surfaces and labels where the colour agrees") {
  KnownLooks statue = plain("sculpture", {0.3, 0.3, 0.9});
  statue.colors = {shown("brown", 1.0, 110, 70, 40)};
  CHECK_FALSE(has(statue, "wooden"));
  statue.surfaces = {{"wooden", 0.6}};
  CHECK(has(statue, "wooden"));
  CHECK(has(statue, "walnut"));          // of wood, and dark
  CHECK_FALSE(has(statue, "pine"));      // of wood, and dark
  CHECK_FALSE(has(statue, "marble"));
  statue.colors = {shown("blue", 1.0, 40, 60, 200)};
  CHECK_FALSE(has(statue, "wooden"));
  statue.surfaces = {{"wooden", 0.6}, {"blue", 0.6}};
  CHECK(has(statue, "wooden"));  // painted
  statue.surfaces = {{"oak", 0.6}};
  CHECK_FALSE(has(statue, "wooden"));  // meshes are called after what they do not show
  statue.colors = {shown("brown", 1.0, 140, 90, 50)};
  CHECK(has(statue, "wooden"));
  // A brown desk is of wood in everybody's eyes, a white one need not be.
  KnownLooks desk = plain("desk", {1.2, 0.6, 0.75});
  desk.colors = {shown("brown", 1.0, 140, 90, 50)};
  CHECK(has(desk, "wooden"));
  desk.colors = {shown("white", 1.0, 250, 250, 250)};
  INFO(judge_attribute(desk, "wooden").reason);
  CHECK_FALSE(has(desk, "wooden"));
  // Whatever its label says.
  desk.identity.words.insert("walnut");
  CHECK_FALSE(has(desk, "walnut"));
}

TEST_CASE("What is in no table can only be read on a label") {
  KnownLooks chair = plain("chair", {0.5, 0.5, 0.9});
  const auto verdict = judge_attribute(chair, "beloved");
  CHECK_FALSE(verdict.held);
  CHECK_FALSE(verdict.judged);
  chair.identity.words.insert("beloved");
  CHECK(has(chair, "beloved"));
}

TEST_CASE("Velvet is rough, a name alone does not make it") {
  KnownLooks sofa = plain("bench", {2, 0.9, 0.8});
  sofa.colors = {shown("blue", 0.9, 20, 30, 80)};
  sofa.surfaces = {{"velvet", 0.3}};
  CHECK_FALSE(has(sofa, "velvet"));
  sofa.surfaces = {{"velvet", 0.95}};
  CHECK(has(sofa, "velvet"));
}

TEST_CASE("A pattern is a drawing on a surface that is called so") {
  KnownLooks rug = plain("rug", {2, 1.4, 0.02});
  rug.surfaces = {{"striped", 0.9}};
  CHECK_FALSE(has(rug, "striped"));
  rug.drawings = {"striped"};
  CHECK(has(rug, "striped"));
  CHECK(has(rug, "patterned"));
  CHECK_FALSE(has(rug, "floral"));
}

TEST_CASE("A style is judged by the colours and materials that its definition has") {
  KnownLooks desk = plain("desk", {1.2, 0.6, 0.75});
  desk.colors = {shown("black", 0.7, 20, 20, 20), shown("brown", 0.3, 90, 60, 40)};
  desk.surfaces = {{"metal", 0.4}};
  CHECK(has(desk, "industrial"));
  CHECK_FALSE(has(desk, "coastal"));
  desk.colors = {shown("pink", 1.0, 230, 160, 180)};
  CHECK_FALSE(has(desk, "industrial"));
}

TEST_CASE("A style's sheen in one of its colours is enough where nothing is known of the material") {
  KnownLooks dresser = plain("dresser", {1.1, 0.5, 0.8});
  dresser.colors = {shown("black", 1.0, 20, 20, 20)};
  dresser.roughness = 0.35;
  CHECK(has(dresser, "sleek"));
  dresser.roughness = 0.8;
  CHECK_FALSE(has(dresser, "sleek"));
  dresser.roughness = 0.35;
  dresser.colors = {shown("pink", 1.0, 230, 160, 180)};
  CHECK_FALSE(has(dresser, "sleek"));
}

TEST_CASE("Parts are those that a recipe made, or that a label counts") {
  KnownLooks dresser = plain("dresser", {1.1, 0.5, 0.8});
  const auto unknown = judge_attribute(dresser, "six_drawer");
  CHECK_FALSE(unknown.held);
  CHECK_FALSE(unknown.judged);
  CHECK_FALSE(has(dresser, "frameless"));
  dresser.making.parts = {{"drawer", 6}, {"leg", 4}};
  dresser.making.ways = {{"leg_style", "turned"}, {"door_style", "sliding"}};
  for (const char* held : {"six_drawer", "6 drawers", "with_drawers", "four_legs", "turned", "sliding", "frameless",
                           "storage"}) {
    INFO(held << ": " << judge_attribute(dresser, held).reason);
    CHECK(has(dresser, held));
  }
  for (const char* not_held : {"five_drawer", "on_wheels", "tufted", "mirrored"}) {
    INFO(not_held);
    CHECK_FALSE(has(dresser, not_held));
    CHECK(judge_attribute(dresser, not_held).judged);
  }
  KnownLooks sofa = plain("sofa", {2, 0.9, 0.8});
  sofa.making.parts = {{"seat", 3}};
  CHECK(has(sofa, "three_seat"));
  CHECK(has(sofa, "three-seater"));
  CHECK_FALSE(has(sofa, "two_seat"));
  CHECK(judge_attribute(sofa, "two_seat").judged);
}

TEST_CASE("A kind that a sort's name stands for is of that sort, a mere synonym tells nothing") {
  CHECK(has(plain("mini fridge", {0.5, 0.5, 0.85}), "bar"));
  CHECK_FALSE(has(plain("candle", {0.1, 0.1, 0.2}), "scented"));
}

TEST_CASE("What may be painted may be judged: tones, substances, shades") {
  KnownLooks chair = plain("chair", {0.5, 0.5, 0.9});
  chair.colors = {shown("red", 0.9, 126, 36, 48)};
  CHECK(has(chair, "claret"));
  CHECK_FALSE(has(chair, "aquamarine"));
  chair.colors = {shown("brown", 0.9, 120, 90, 60)};
  CHECK_FALSE(has(chair, "weathered"));
  chair.surfaces = {{"weathered", 0.8}, {"oak", 0.8}};
  CHECK(has(chair, "weathered"));
}

TEST_CASE("Sturdy is what does not tip over") {
  ModelTable models;
  const auto is_sturdy = [&](const Vec3& size, const std::string& mesh) {
    Object object = rooms::thing(mesh, "table", size, {1, 1});
    test::use_model(object, models, mesh, test::colored_box(size, {90, 60, 40}));
    return judge_attribute(known_looks(object, models), "sturdy").held;
  };
  CHECK(is_sturdy({1.2, 0.7, 0.75}, "low"));
  CHECK_FALSE(is_sturdy({0.3, 0.3, 1.8}, "tower"));
}

TEST_CASE("Sizes in numbers are those of the box") {
  const KnownLooks table = plain("table", {1.6, 0.8, 0.75});
  for (const char* held : {"160_cm_wide", "1.6 m", "80_cm_deep", "160x80_cm", "75 cm high", "at_most_1_m_tall", "at least 1.5 m long"}) {
    INFO(held);
    CHECK(has(table, held));
  }
  for (const char* not_held : {"120_cm_wide", "2 m", "60x60_cm", "1_m_tall", "at_most_1_m_long"}) {
    INFO(not_held);
    const auto verdict = judge_attribute(table, not_held);
    CHECK_FALSE(verdict.held);
    CHECK(verdict.judged);
  }
}

TEST_CASE("Sizes are against the usual") {
  KnownLooks shelf = plain("bookshelf", {0.8, 0.3, 1.0});
  CHECK_FALSE(has(shelf, "large"));
  shelf.size = {1.2, 0.3, 1.2};
  CHECK(has(shelf, "large"));
  CHECK_FALSE(has(shelf, "small"));
  shelf.size = {0.4, 0.3, 0.5};
  CHECK(has(shelf, "small"));
  shelf.size = {0.8, 0.3, 2.0};
  CHECK(has(shelf, "tall"));
}

TEST_CASE("Outlines of discs, plates and an L, whatever their size") {
  for (const double scale : {0.1, 1.0, 3.0}) {
    CHECK(outline_of(disc(scale)) == Outline::round);
    CHECK(outline_of(make_box(Vec3::Zero(), scale * Vec3(1, 1, 0.5))) == Outline::square);
    CHECK(outline_of(make_box(Vec3::Zero(), scale * Vec3(2, 1, 0.5))) == Outline::rectangular);
    Mesh corner = make_box(Vec3::Zero(), scale * Vec3(3, 1, 0.5));
    append(corner, make_box(Vec3::Zero(), scale * Vec3(1, 3, 0.5)));
    CHECK(outline_of(corner) == Outline::l_shaped);
  }
  // A flat thing that hangs is looked at from its front.
  Mesh mirror = disc(0.4);
  for (auto& p : mirror.positions) p = {p.x(), 0.01f * p.y(), p.y()};
  CHECK(outline_of(mirror) == Outline::round);
}
