#include "prints.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "evaluate/attributes.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

CreatedObject made_of(const std::string& words, std::uint64_t seed = 1) {
  const auto maker = make_rule_maker();
  CreateOptions options;
  options.seed = seed;
  const auto creation = create::create(words, *maker, options);
  INFO((creation ? "" : creation.error().message));
  REQUIRE(creation);
  REQUIRE_FALSE(creation->objects.empty());
  return creation->objects.front();
}

std::string program_of(const CreatedObject& object) {
  return shape::write_program(object.program).dump();
}

}  // namespace

TEST_CASE("What is printed is read from a description") {
  const struct {
    const char *description, *motif, *palette, *words;
  } cases[] = {{"a poster of a whale", "whale", "", ""},
               {"a Japanese scroll with cranes", "crane", "ink", ""},
               {"a neon sign that says \"JAZZ\"", "", "", "JAZZ"},
               {"a neon sign saying OPEN LATE", "", "", "OPEN LATE"},
               {"a pink neon sign with the words 'good vibes'", "", "", "good vibes"},
               {"a child's painting of a cat", "cat", "", ""},
               {"a pop art print of a guitar", "guitar", "pop", ""},
               {"a sign that reads \"moon\"", "", "", "moon"},
               {"a black metal frame", "", "", ""}};
  for (const auto& one : cases) {
    INFO(one.description);
    const Print print = print_in(one.description);
    CHECK(print.motif == one.motif);
    CHECK(print.palette == one.palette);
    CHECK(print.words == one.words);
  }
}

TEST_CASE("Pictures show what was said, and signs spell it") {
  const std::pair<const char*, const char*> cases[] = {
      {"a poster of a whale", R"("use":"whale")"},
      {"a large painting of mountains", R"("use":"mountains")"},
      {"a tapestry with a dragon", R"("use":"dragon")"},
      {"a star map poster", R"("use":"star chart")"},
      {"a poster that says \"STAY CURIOUS\"", R"("text":"STAY\nCURIOUS")"},
      {"a chalkboard menu", R"("text":"MENU)"},
      {"a neon sign that says \"HELLO\"", R"("words":"HELLO")"},
      {"a wooden sign that says \"Bakery\"", R"("words":"Bakery")"}};
  for (const auto& [words, part] : cases) {
    INFO(words);
    const CreatedObject object = made_of(words);
    const std::string program = program_of(object);
    INFO(program);
    CHECK(contains_text(program, part));
    CHECK(object.soundness.pieces == 1);
  }
}

TEST_CASE("Neon letters shine in the colour that was said") {
  const CreatedObject sign = made_of("a blue neon sign that says \"HELLO\"");
  bool found = false;
  for (const auto& body : sign.shape.bodies) {
    if (body.label != "letters") continue;
    const Material& material = sign.shape.materials[static_cast<std::size_t>(body.material)];
    found = true;
    CHECK(material.glow > 0.5f);
    CHECK(material.base_color[2] > material.base_color[0]);
  }
  CHECK(found);
}

TEST_CASE("Posters of which nothing is said differ") {
  CHECK(program_of(made_of("a poster", 1)) != program_of(made_of("a poster", 4)));
}

TEST_CASE("Cloth shows what its words say, and is no print where they name a colour") {
  CHECK(contains_text(program_of(made_of("a blanket with dinosaurs")), R"("pattern":"dinosaur")"));
  CHECK(contains_text(program_of(made_of("a navy cushion with anchors")), R"("pattern":"anchor")"));
  const std::string rug = program_of(made_of("a round rug with a compass"));
  CHECK(contains_text(rug, R"("use":"compass")"));
  CHECK(contains_text(program_of(made_of("curtains with owls")), R"("use":"owl")"));
  CHECK_FALSE(contains_text(program_of(made_of("a lemon cushion")), R"("pattern":"lemon")"));
  // It is painted on the cloth, and nothing of the colour is lost.
  const auto anchors = made_of("a navy cushion with anchors");
  const auto& cloth = anchors.shape.materials.front();
  REQUIRE(cloth.texture);
  const auto& pixels = cloth.texture->pixels;
  CHECK(std::set<std::uint8_t>(pixels.begin(), pixels.end()).size() > 3);
}

TEST_CASE("What is written on a made thing is known") {
  const auto library = make_created_library();
  AssetQuery sign;
  sign.category = "neon sign";
  sign.description = "neon sign that says NORDWIND";
  sign.asked = true;
  const auto found = library->search(sign);
  REQUIRE(found);
  REQUIRE_FALSE(found->empty());
  Object object;
  object.category = "neon sign";
  object.asset = found->front().asset.ref;
  ModelTable models;
  models.add(asset_key(object.asset), *library->load(object.asset));
  const auto looks = known_looks(object, models);
  CHECK(judge_attribute(looks, "says NORDWIND").held);
  CHECK_FALSE(judge_attribute(looks, "saying SUEDWIND").held);
}
