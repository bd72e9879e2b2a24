// Looks by words: which parts get them, and that they show.
#include "catch.h"
#include "finish_look.h"
#include "library/style_words.h"
#include "part_paint.h"
#include "repaint.h"
#include "roomgen/base/file.h"
#include "roomgen/create/create.h"
#include "evaluate/attributes.h"
#include "library/attribute_words.h"
#include "scene/finish.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

using Finishes = std::map<std::string, std::string>;

Material named(const std::string& name, const Tone& tone) {
  Material material;
  material.name = name;
  material.base_color = material_color(tone);
  return material;
}

// A seat of cloth on legs of metal beside a pane of glass.
Model seat() {
  Model model;
  model.materials = {named("Cushion1", {200, 30, 30}), named("black-metal", {20, 20, 20}), named("pane", {200, 220, 220})};
  model.materials[2].base_color[3] = 0.3f;
  model.parts = {{make_box({-0.5, -0.5, 0.3}, {0.5, 0.5, 0.5}), 0},
                 {make_box({-0.05, -0.05, 0}, {0.05, 0.05, 0.3}), 1},
                 {make_box({-0.5, 0.5, 0.3}, {0.5, 0.51, 0.8}), 2}};
  return model;
}

Tone tone_of_part(const Model& model, std::size_t part) {
  return mean_tone(model.materials[static_cast<std::size_t>(model.parts[part].material)]);
}

}  // namespace

TEST_CASE("The tables of finishes and styles are sound") {
  const std::string data = std::string(ROOMGEN_SOURCE_DIR) + "/data/";
  const auto finishes = parse_finish_table(*read_file(data + "finishes.json"), "finishes.json");
  if (!finishes) FAIL(finishes.error().message);
  const auto styles = StyleWords::parse(*read_file(data + "styles.json"), "styles.json");
  if (!styles) FAIL(styles.error().message);
  for (const auto& [kinds, main] : finishes->made_of)
    for (const auto& kind : kinds) {
      INFO(kind);
      CHECK(KindTable::built_in().by_name(kind));
    }
  for (const auto& [name, style] : styles->all()) {
    INFO(name);
    for (const auto& look : style.looks) {
      for (const auto& kind : look.kinds) CHECK(KindTable::built_in().by_name(kind));
      for (const auto& words : look.words) CHECK_FALSE(read_look(words).empty());
    }
    for (const auto* kinds : {&style.more, &style.fewer})
      for (const auto& kind : *kinds) CHECK(KindTable::built_in().by_name(kind));
    for (const auto& material : style.materials) CHECK(AttributeWords::built_in().find(material));
  }
}

TEST_CASE("Words of looks stand for the parts that show them") {
  CHECK(wanted_finish("navy velvet", "sofa") == Finishes{{"upholstery", "navy velvet"}});
  CHECK(wanted_finish("black metal and dark oak", "desk") == Finishes{{"metal", "black metal"}, {"wood", "dark oak"}});
  CHECK(wanted_finish("glossy black", "toilet") == Finishes{{"ceramic", "glossy black"}});
  CHECK(wanted_finish("black and white striped", "rug") == Finishes{{"upholstery", "black white striped"}});
  CHECK(wanted_finish("small comfortable", "sofa").empty());
  CHECK(wanted_finish("green leafy", "plant").empty());
  CHECK(wanted_finish("white sofa with brass legs", "sofa") == Finishes{{"metal", "brass"}, {"upholstery", "white"}});
}

TEST_CASE("Legs and panes keep their looks when the seat gets another one") {
  PaintBox paints;
  Model model = seat();
  repaint(model, {{"upholstery", "navy velvet"}}, paints);
  CHECK(tone_of_part(model, 0).z() > tone_of_part(model, 0).x());
  CHECK(tone_of_part(model, 1).isApprox(tone_of_part(seat(), 1), 1e-3f));
  CHECK(tone_of_part(model, 2).isApprox(tone_of_part(seat(), 2), 1e-3f));
  CHECK(model.materials[static_cast<std::size_t>(model.parts[0].material)].texture);
  CHECK(model.parts[0].mesh.uvs.size() == model.parts[0].mesh.positions.size());
  Model legs = seat();
  repaint(legs, {{"metal", "brass"}, {"upholstery", "white"}}, paints);
  CHECK(tone_of_part(legs, 0).minCoeff() > 200.0f);
  CHECK(tone_of_part(legs, 1).x() > 100.0f);
}

TEST_CASE("Glass is not made of what is none") {
  PaintBox paints;
  Model model = seat();
  model.parts.pop_back();
  const Model before = model;
  repaint(model, {{"glass", "glass"}}, paints);
  for (std::size_t part = 0; part < 2; ++part)
    CHECK(tone_of_part(model, part).isApprox(tone_of_part(before, part), 1e-3f));
}

TEST_CASE("What is painted in a colour is judged to have it") {
  PaintBox paints;
  std::size_t judged = 0;
  for (const auto& [word, tone] : finish_table().tones) {
    const auto* meaning = AttributeWords::built_in().find(word);
    if (!meaning || !meaning->materials.empty()) continue;
    Model model;
    model.materials = {named("", {128, 128, 128})};
    model.parts = {{make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.5}), 0}};
    repaint(model, {{"wood", word}}, paints);
    KnownLooks looks;
    looks.colors = shown_colors(model);
    INFO(word << ": " << judge_attribute(looks, word).reason);
    CHECK(judge_attribute(looks, word).held);
    ++judged;
  }
  CHECK(judged > 80);
}

TEST_CASE("A library gives its things the looks that were asked for, and makes them so again") {
  const auto library = make_finishing_library(std::shared_ptr<const AssetLibrary>(make_created_library()));
  AssetQuery query;
  query.category = "sofa";
  query.description = "navy velvet sofa";
  query.asked = true;
  const auto matches = library->search(query);
  REQUIRE(matches);
  REQUIRE_FALSE(matches->empty());
  const AssetRef& ref = matches->front().asset.ref;
  CHECK(ref.finish == Finishes{{"upholstery", "navy velvet"}});
  const auto model = library->load(ref);
  REQUIRE(model);
  CHECK(shown_colors(**model).front().name == "blue");
  const auto again = make_finishing_library(std::shared_ptr<const AssetLibrary>(make_created_library()))->load(ref);
  REQUIRE(again);
  CHECK((*again)->parts.size() == (*model)->parts.size());
  query.description = "travertine sofa";
  CHECK(library->search(query)->front().asset.ref.finish == Finishes{{"stone", "travertine"}});
  query.description = "gothic sofa";
  CHECK(library->search(query)->front().asset.ref.finish == Finishes{{"upholstery", "burgundy velvet"}});
  // What is added to what was asked for looks as it is described, too.
  query.description = "navy velvet sofa";
  const auto asked = library->search(query)->front().asset.ref.finish;
  query.asked = false;
  CHECK_FALSE(asked.empty());
  CHECK(library->search(query)->front().asset.ref.finish == asked);
}

TEST_CASE("Worked stuffs have the tone that the words say, on things and on walls") {
  const auto light = [](const Tone& tone) { return tone.mean(); };
  const auto redness = [](const Tone& tone) { return tone.x() - 0.5f * (tone.y() + tone.z()); };
  const auto on_wall = [](const std::string& words) {
    const auto plain = make_finish(words, RoomPart::walls, "living room").plain;
    return Tone(255.0f * plain[0], 255.0f * plain[1], 255.0f * plain[2]);
  };
  for (const char* stuff : {"brick", "ash", "oak", "stone", "pine"}) {
    const std::string plain = stuff;
    INFO(plain);
    for (const char* work : {"whitewashed ", "limed ", "bleached "}) {
      CHECK(light(*read_look(work + plain).tone()) > light(*read_look(plain).tone()));
      CHECK(light(on_wall(work + plain)) > light(on_wall(plain)));
    }
    for (const char* way : {"raw ", "rough ", "bare "}) {
      CHECK(*read_look(way + plain).tone() == *read_look(plain).tone());
      CHECK(on_wall(way + plain) == on_wall(plain));
    }
    CHECK(redness(*read_look("rough grey " + plain).tone()) < 15);
    CHECK_FALSE(wanted_finish("rough grey " + plain, "coffee table").empty());
  }
}
