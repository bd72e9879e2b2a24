#include "rule_steps.h"

#include "catch.h"

using namespace roomgen;
using namespace roomgen::create;

namespace {

std::vector<Description> read(const std::string& prompt) {
  REQUIRE(built_in_words());
  REQUIRE(ShapeKinds::built_in());
  return read_phrase(prompt, *built_in_words(), *ShapeKinds::built_in());
}

const PartWish* part(const Description& description, const std::string& label) {
  for (const auto& wish : description.parts)
    if (wish.label == label) return &wish;
  return nullptr;
}

struct Case {
  std::string prompt, kind, label;
  int count;  ///< of the part; -1: not said
};

}  // namespace

TEST_CASE("Kinds, parts and their numbers are read from descriptions") {
  const std::vector<Case> cases = {
      {"a bar stool with a round seat and three slanted legs", "bar stool", "leg", 3},
      {"a three-legged stool", "stool", "leg", 3},
      {"a two-drawer nightstand", "nightstand", "drawer", 2},
      {"a desk with two drawers and metal legs", "desk", "drawer", 2},
      {"an armchair without armrests", "armchair", "armrest", 0},
      {"a bookshelf with five shelves", "bookshelf", "shelf", 5},
      {"bookcase having 6 shelves", "bookcase", "shelf", 6},
      {"a wooden chair that has four tapered legs", "chair", "leg", 4},
      {"a sofa with three cushions, in dark blue velvet", "sofa", "cushion", 3},
      {"a round dining table on a single pedestal base", "dining table", "base", 1},
      {"a dresser with 6 drawers and brass knobs", "dresser", "drawer", 6}};
  for (const auto& one : cases) {
    INFO(one.prompt);
    const auto objects = read(one.prompt);
    REQUIRE(objects.size() == 1);
    CHECK(objects[0].kind == one.kind);
    CHECK_FALSE(objects[0].approximate);
    const PartWish* wish = part(objects[0], one.label);
    REQUIRE(wish);
    CHECK(wish->count.value_or(-1) == one.count);
  }
}

TEST_CASE("Adjectives belong to their nouns") {
  const auto stool = read("a tall black bar stool with a round oak seat and three slanted brass legs")[0];
  CHECK(stool.color == "black");
  CHECK(stool.scale.z() > 1);
  CHECK(part(stool, "seat")->shape == "round");
  CHECK(part(stool, "seat")->material == "oak");
  CHECK(part(stool, "leg")->material == "brass");
  CHECK(part(stool, "leg")->lean.value_or(0) > 5);

  const auto chair = read("a chair with a gently curved back and legs that are twisted, made of walnut")[0];
  CHECK(part(chair, "back")->course == Course::arc);
  CHECK(part(chair, "back")->strength == Strength::gentle);
  CHECK(part(chair, "leg")->course == Course::spiral);

  const auto table = read("a coffee table made of glass")[0];
  CHECK(table.material == "glass");
  CHECK(read("an industrial desk")[0].style == "industrial");
}

TEST_CASE("Sizes are read with their units and axes") {
  const auto stool = read("a stool, 80 cm tall and 0.4 m wide")[0];
  REQUIRE(stool.size);
  CHECK(stool.size->z() == Approx(0.8));
  CHECK(stool.size->x() == Approx(0.4));
  CHECK(std::isnan(stool.size->y()));
  const auto table = read("a table of 120 x 60 x 75 cm")[0];
  REQUIRE(table.size);
  CHECK((*table.size - Vec3(1.2, 0.6, 0.75)).norm() < 1e-9);
}

TEST_CASE("Other things that are named are objects of their own, with their relation") {
  const auto objects = read("a dining table with cups on it and four chairs around it");
  REQUIRE(objects.size() == 3);
  CHECK(objects[0].kind == "dining table");
  CHECK(objects[1].kind == "cup");
  CHECK(objects[1].relation == "on");
  CHECK(objects[2].kind == "chair");
  CHECK(objects[2].count == 4);
  CHECK(objects[2].relation == "around");
}

TEST_CASE("What is no thing of a room is refused with the reason") {
  const auto verdict = [](const std::string& prompt) {
    return classify_phrase(prompt, read(prompt), *built_in_words());
  };
  for (const char* prompt :
       {"a car", "a poem about the sea", "", "   ", "a chair with -3 legs", "a 1 km table",
        "a mountain", "an elephant", "the weather of tomorrow", "a table 40 m long", "?!"}) {
    INFO(prompt);
    const auto answer = verdict(prompt);
    CHECK_FALSE(answer.passes);
    CHECK(answer.reason.size() > 10);
  }
  for (const char* prompt : {"a stool", "a toy car", "a bed shaped like a car", "an umbrella stand",
                             "a chair with 3 legs", "a bird cage"}) {
    INFO(prompt);
    CHECK(verdict(prompt).passes);
  }
  CHECK_FALSE(classify_phrase(std::string(100000, 'a'), {}, *built_in_words()).passes);
}
