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
  CHECK_FALSE(parse(R"({"mount": "sky"})"));
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

TEST_CASE("Attributes count the things that have all of them") {
  Scene scene;
  scene.room = rooms::box(5, 4);
  ModelTable models;
  const auto add = [&](const std::string& id, const std::string& mesh, const Eigen::Vector3f& color) {
    Object object = rooms::thing(id, "desk", {1.2, 0.6, 0.75}, {1 + scene.objects.size() * 1.5, 2});
    test::use_model(object, models, mesh, test::colored_box(object.size, color));
    scene.objects.push_back(object);
  };
  add("desk-0", "plain_desk", {255, 0, 0});
  add("desk-1", "simple_desk", {0, 0, 255});
  const auto score = [&](const std::string& attributes) {
    const auto rows = parse_requirements("ID,Description,ObjCount,ObjAttr\n1,x,\"eq,2,desk\",\"" + attributes + "\"\n", "r");
    return score_room(rows->front(), scene, models);
  };
  CHECK(score("eq,1,desk,red").attributes.front().satisfied);
  CHECK_FALSE(score("eq,2,desk,red").attributes.front().satisfied);
  CHECK_FALSE(score("eq,1,desk,red,round").attributes.front().satisfied);
  CHECK(score("eq,1,desk,blue,rectangular").attributes.front().satisfied);
  const auto missing = score("eq,1,sofa,red").attributes.front();
  CHECK_FALSE(missing.satisfied);
  CHECK(missing.missing == "sofa");
  CHECK(score("eq,1,desk,beloved").attributes.front().unjudged == std::vector<std::string>{"beloved"});
}
