#include "roomgen/export/exporter.h"

#include "catch.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

Scene credited() {
  Scene scene = test::furnished_room();
  for (const std::size_t i : {0u, 1u}) {
    scene.objects[i].asset.library = "Scopia";
    scene.objects[i].asset.id = "bed1";
    scene.objects[i].asset.creator = "A | B";
    scene.objects[i].asset.license = "CC-BY 3.0";
  }
  return scene;
}

}  // namespace

TEST_CASE("every work is credited once, with all objects that use it") {
  const std::string text = attribution_markdown(credited());
  CHECK(text.find("| bed1 | A \\| B | CC-BY 3.0 | Scopia | bed-0, desk-0 |") != std::string::npos);
  CHECK(text.find("bed1") == text.rfind("bed1"));
}

TEST_CASE("the line for other formats names work, creator, licence and library") {
  CHECK(attribution_line(credited()) == "bed1 by A | B (CC-BY 3.0, Scopia)");
}

TEST_CASE("boxes need no credit") {
  CHECK(attribution_line(test::furnished_room()).empty());
  CHECK(attribution_markdown(test::furnished_room()).find("made by roomgen") != std::string::npos);
}
