#include <cmath>
#include <nlohmann/json.hpp>

#include "conversation.h"

#include "roomgen/base/json.h"

using namespace conversation;

namespace {

const std::string good_objects = R"({"objects": [{"object": "stool", "words": "a round stool",
  "kind": "stool", "approximate": false, "count": 2, "style": "", "material": "oak", "color": "",
  "size_cm": [40, 40, 45], "parts": [
    {"label": "Legs", "count": "three", "size_cm": [3, 3, 42], "shape": "round", "symmetry": "ring",
     "lean": 8, "course": "S-Curve", "strength": "gentle", "direction": "outward",
     "touches": ["seat", "floor"]},
    {"label": "seat", "count": 1, "size_cm": [40, 40, 3], "touches": ["legs"]},
    {"label": "back", "count": 0}]}]})";

std::vector<Description> decomposed(const std::string& answer) {
  ModelMakerOptions options;
  options.kinds = {"chair", "stool"};
  Conversation talk({reply_saying(answer)}, options);
  auto objects = talk.maker->decompose("two round stools of oak");
  REQUIRE(objects);
  REQUIRE(talk.script->questions.size() == 1);
  return *std::move(objects);
}

}  // namespace

TEST_CASE("A verdict is read as it is said") {
  const auto verdict_of = [](const std::string& answer) {
    Conversation talk({reply_saying(answer)});
    const auto verdict = talk.maker->classify("a thing");
    REQUIRE(verdict);
    REQUIRE(talk.script->questions.size() == 1);
    return *verdict;
  };
  CHECK(verdict_of(R"({"passes": true, "reason": "a chair"})").reason == "a chair");
  CHECK_FALSE(verdict_of(R"({"passes": false, "reason": "a mountain"})").passes);
  CHECK(verdict_of("It is one. ```json\n{'verdict': 'pass', 'explanation': 'a lamp'}\n```").passes);
  CHECK_FALSE(verdict_of(R"({"classification": "does not pass"})").passes);
}

TEST_CASE("The objects of a sentence are taken as the model says them") {
  const auto objects = decomposed(good_objects);
  REQUIRE(objects.size() == 1);
  const Description& stool = objects[0];
  CHECK(stool.noun == "stool");
  CHECK(stool.kind == "stool");
  CHECK(stool.count == 2);
  CHECK(stool.prompt == "a round stool");
  CHECK((*stool.size - Vec3(0.4, 0.4, 0.45)).norm() < 1e-9);
  REQUIRE(stool.parts.size() == 3);
  const PartWish& leg = stool.parts[0];
  CHECK(leg.label == "leg");
  CHECK(leg.count == 3);
  CHECK(leg.course == Course::s_curve);
  CHECK(leg.strength == Strength::gentle);
  CHECK(contains_text(leg.construction, "in a ring"));
  CHECK(*leg.lean == 8.0);
  CHECK(leg.touches == std::vector<std::string>{"seat", "floor"});
  CHECK(stool.parts[1].touches == std::vector<std::string>{"leg"});
  CHECK(stool.parts[2].count == 0);
  CHECK(description_from_json(to_json(stool), "test"));
}

TEST_CASE("The kinds and the words are shown to the model") {
  ModelMakerOptions options;
  options.kinds = {"chair", "stool"};
  Conversation talk({reply_saying(good_objects)}, options);
  REQUIRE(talk.maker->decompose("two round stools"));
  CHECK(contains_text(talk.question(0), "two round stools"));
  CHECK(contains_text(talk.question(0), "chair, stool"));
  CHECK(talk.script->questions[0].schema["properties"].contains("objects"));
}

TEST_CASE("A decomposition is read in other words, too") {
  const auto objects = decomposed(
      "Sure!\n{\"name\": \"Table\", \"dimensions\": {\"width\": \"1.2 m\", \"depth\": \"80 cm\"},"
      "\"components\": [\"top\", {\"component\": \"legs\", \"quantity\": 4, \"size\": null,"
      "\"curvature\": {\"type\": \"taper\", \"intensity\": \"pronounced\"}}],"
      "\"connections\": [[\"legs\", \"top\"]]}");
  REQUIRE(objects.size() == 1);
  CHECK(objects[0].prompt == "two round stools of oak");
  CHECK(std::abs(objects[0].size->x() - 1.2) < 1e-9);
  CHECK(std::abs(objects[0].size->y() - 0.8) < 1e-9);
  CHECK(std::isnan(objects[0].size->z()));
  REQUIRE(objects[0].parts.size() == 2);
  CHECK(objects[0].parts[0].label == "top");
  CHECK(objects[0].parts[1].course == Course::taper);
  CHECK(objects[0].parts[1].strength == Strength::pronounced);
  CHECK(objects[0].parts[1].touches == std::vector<std::string>{"top"});
}

TEST_CASE("Sizes in metres are noticed, of the parts as well") {
  const auto objects = decomposed(R"({"objects": [{"object": "stool", "size_cm": [0.4, 0.4, 0.45],
      "parts": [{"label": "leg", "size_cm": [0.03, 0.03, 0.42]}]}]})");
  CHECK((*objects[0].size - Vec3(0.4, 0.4, 0.45)).norm() < 1e-9);
  CHECK((*objects[0].parts[0].size - Vec3(0.03, 0.03, 0.42)).norm() < 1e-9);
}

TEST_CASE("What cannot be meant is bounded and left out") {
  const auto objects = decomposed(R"({"objects": [{"object": "stool", "count": 100000,
      "kind": "spaceship", "size_cm": [1e6, -4, 45], "parts": [{"count": 3},
      {"label": "leg", "count": "enough", "lean": 900, "course": "zigzag", "size_cm": [0, 0, 0]}]}]})");
  CHECK(objects[0].count == 200);
  CHECK(objects[0].kind.empty());
  CHECK(objects[0].size->x() <= 20.0);
  REQUIRE(objects[0].parts.size() == 1);
  CHECK_FALSE(objects[0].parts[0].count);
  CHECK_FALSE(objects[0].parts[0].size);
  CHECK_FALSE(objects[0].parts[0].course);
  CHECK(description_from_json(to_json(objects[0]), "test"));
}

TEST_CASE("A decomposition without parts is asked for once more, and then taken") {
  const std::string bare = R"({"objects": [{"object": "stool", "parts": []}]})";
  Conversation talk({reply_saying(bare), reply_saying(bare)});
  const auto objects = talk.maker->decompose("a stool");
  REQUIRE(objects);
  CHECK(objects->front().noun == "stool");
  CHECK(talk.script->questions.size() == 2);
  CHECK(contains_text(talk.question(1), "/objects/0/parts"));
}

TEST_CASE("Without decomposition the words stand alone and nobody is asked") {
  ModelMakerOptions options;
  options.variant = Variant::no_decomposition;
  Conversation talk({reply_saying(good_stool)}, options);
  const auto objects = talk.maker->decompose("a stool with a pink seat");
  REQUIRE(objects);
  CHECK(talk.script->questions.empty());
  REQUIRE(objects->size() == 1);
  CHECK(objects->front().prompt == "a stool with a pink seat");
  Description with_parts = objects->front();
  with_parts.parts.push_back(part("antler"));
  REQUIRE(talk.generate(with_parts));
  CHECK(contains_text(talk.question(0), "pink seat"));
  CHECK_FALSE(contains_text(talk.question(0), "antler"));
}
