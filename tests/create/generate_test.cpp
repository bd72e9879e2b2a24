#include <nlohmann/json.hpp>

#include "conversation.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/shape/program.h"

using namespace conversation;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::size_t bodies_of(const shape::Program& program) {
  const auto shape = shape::evaluate(program);
  REQUIRE(shape);
  return shape->bodies.size();
}

}  // namespace

TEST_CASE("A program comes out as the model wrote it, its formulas computed") {
  Conversation talk({reply_saying(good_stool)});
  const auto program = talk.generate();
  REQUIRE(program);
  CHECK(program->name == "stool");
  CHECK(bodies_of(*program) == 5);
  CHECK(std::abs(program->components[1].at.z() - 0.418) < 1e-9);
  CHECK(program->connections.size() == 2);
  CHECK(talk.maker->take_notes().empty());
  CHECK(talk.script->questions.front().schema["properties"].contains("components"));
}

TEST_CASE("A program is found among prose, fences and thoughts") {
  for (const std::string& answer :
       {"Here it is:\n```json\n" + good_stool + "\n```\nEnjoy your stool!",
        "<think>{\"components\": []} or so?</think>" + good_stool,
        "{\"reasoning\": \"four legs\", \"program\": " + good_stool + "}",
        replaced(good_stool, "\"version\": 1,", "\"version\": 1, // first\n")}) {
    Conversation talk({reply_saying(answer)});
    const auto program = talk.generate();
    REQUIRE(program);
    CHECK(bodies_of(*program) == 5);
    CHECK(talk.script->questions.size() == 1);
  }
}

TEST_CASE("The words, the parts and the nearest programs are shown to the model") {
  Conversation talk({reply_saying(good_stool)});
  MakeRequest request;
  request.description = Conversation::stool();
  request.description.parts.push_back(part("leg", 4));
  request.description.parts.back().construction = "turned";
  request.examples = {*shape::instantiate(Json::parse(good_stool))};
  request.examples[0].about = "an example that is near";
  REQUIRE(talk.maker->generate(request));
  for (const char* word : {"a stool on four legs", "turned", "an example that is near"})
    CHECK(contains_text(talk.question(0), word));
  CHECK_FALSE(contains_text(talk.question(0), "{{"));
}

TEST_CASE("The reader's error goes back with its pointer, and the mended program counts") {
  Conversation talk({reply_saying(replaced(good_stool, "\"h\"]}, \"at\"", "\"hight\"]}, \"at\"")),
                     reply_saying(good_stool)});
  const auto program = talk.generate();
  REQUIRE(program);
  CHECK(bodies_of(*program) == 5);
  CHECK(contains_text(talk.question(1), "/components/0/box/size"));
  CHECK(contains_text(talk.question(1), "hight"));
  // The model sees its own program again.
  CHECK(contains_text(talk.script->questions[1].messages[2].text, "hight"));
  CHECK(mentions(talk.maker->take_notes(), "asked again"));
}

TEST_CASE("A program that was cut off is asked for again") {
  ChatReply half = reply_saying(good_stool.substr(0, good_stool.find("{\"name\": \"seat\"") + 40));
  half.cut_off = true;
  Conversation talk({half, reply_saying(good_stool)});
  const auto program = talk.generate();
  REQUIRE(program);
  CHECK(bodies_of(*program) == 5);
  CHECK(contains_text(talk.question(1), "cut off"));
}

TEST_CASE("Prose three times leaves it to the fallback, which is said") {
  Conversation talk({reply_saying("A stool has legs."), reply_saying("{}"), reply_saying("No.")});
  const auto program = talk.generate();
  REQUIRE(program);
  CHECK(program->name == "box");
  CHECK(talk.script->questions.size() == 3);
  const auto notes = talk.maker->take_notes();
  CHECK(mentions(notes, "rules made this one"));
  CHECK(mentions(notes, "a box was made"));
  CHECK(talk.maker->take_notes().empty());
}

TEST_CASE("A program that is not what was described is asked for once more") {
  Description wanted = Conversation::stool();
  wanted.parts.push_back(part("leg", 3));
  wanted.size = Vec3(0.4, 0.4, 0.9);
  Conversation talk({reply_saying(good_stool), reply_saying(good_stool)});
  const auto program = talk.generate(wanted);
  REQUIRE(program);
  CHECK(program->name == "stool");
  CHECK(talk.script->questions.size() == 2);
  CHECK(contains_text(talk.question(1), "there are 4 parts labelled \"leg\", but 3"));
  CHECK(contains_text(talk.question(1), "40 x 40 x 90"));
  // When the second answer is no program, the first is better than none.
  Conversation worse({reply_saying(good_stool), reply_saying("no"), reply_saying("no")});
  CHECK(worse.generate(wanted)->name == "stool");
  Conversation lost({reply_saying(good_stool)});
  CHECK(lost.generate(wanted)->name == "stool");
}

TEST_CASE("Parts are counted by label, groups as wholes") {
  const std::string chest = R"({"components": [
    {"name": "drawer", "label": "drawer", "group": {"components": [
       {"name": "front", "box": {"size": [0.4, 0.02, 0.2]}},
       {"name": "knob", "label": "handle", "box": {"size": [0.02, 0.02, 0.02]}}]},
     "operations": [{"array": {"count": 3, "step": [0, 0, 0.2]}}]},
    {"name": "foot-left", "label": "front legs", "box": {"size": [0.02, 0.02, 0.1]},
     "operations": [{"mirror": "x"}]}]})";
  Description wanted = Conversation::stool();
  wanted.parts = {part("drawer", 3), part("handle", 3), part("leg", 2), part("door", 0)};
  Conversation talk({reply_saying(chest)});
  REQUIRE(talk.generate(wanted));
  CHECK(talk.script->questions.size() == 1);
  wanted.parts = {part("drawer", 2), part("leg", 0)};
  Conversation other({reply_saying(chest), reply_saying(chest)});
  REQUIRE(other.generate(wanted));
  CHECK(contains_text(other.question(1), "3 parts labelled \"drawer\", but 2"));
  CHECK(contains_text(other.question(1), "2 parts labelled \"leg\", but 0"));
}

TEST_CASE("What is clear in a program is mended without asking") {
  const std::string sloppy = R"({"name": "stool", "reasoning": "legs first",
    "materials": [{"name": "wood", "color": "light oak", "shininess": 3}],
    "components": [
      {"id": "Left Leg", "label": "leg", "type": "box", "size": [0.04, 0.04, 0.42],
       "position": [0.17, 0, 0], "operations": [{"mirror": "x"}], "material": "wood"},
      {"name": "ball", "sphere": {"radius": 0.05}, "position": [0, 0, 0.3], "color": "red"},
      {"name": "ball", "solid": {"type": "sphere", "radius": 0.05}, "material": "dark walnut"},
      {"name": "seat", "box": {"size": [0.4, 0.4, 0.03]}, "at": [0, 0, 0.42],
       "material": {"color": "matte black"}}],
    "connections": [{"from": "Left Leg", "to": "seat"}, ["ground", "legs"], ["leg-0", "antler"],
                    ["leg"]]})";
  Conversation talk({reply_saying(sloppy)});
  const auto program = talk.generate();
  INFO((talk.script->questions.size() > 1 ? talk.question(1) : ""));
  REQUIRE(talk.script->questions.size() == 1);
  CHECK(bodies_of(*program) == 5);
  CHECK(program->components[0].name == "Left-Leg");
  CHECK(program->components[2].name == "ball_2");
  CHECK(program->components[2].label == "ball");
  REQUIRE(program->connections.size() == 2);
  CHECK(program->connections[0] == std::pair<std::string, std::string>("Left-Leg", "seat"));
  CHECK(program->connections[1] == std::pair<std::string, std::string>("leg", "floor"));
  CHECK(mentions(talk.maker->take_notes(), "\"light oak\" was taken as oak"));
}

TEST_CASE("A change shows the earlier program and the wish") {
  const auto earlier = shape::instantiate(Json::parse(good_stool));
  REQUIRE(earlier);
  MakeRequest request;
  request.description = Conversation::stool();
  request.description.prompt = "paint the seat blue";
  request.description.size = Vec3(2, 2, 2);
  request.earlier = &*earlier;
  Conversation talk({reply_saying(replaced(good_stool, "oak", "blue"))});
  const auto program = talk.maker->generate(request);
  REQUIRE(program);
  CHECK(program->materials[0].color == "blue");
  CHECK(talk.script->questions.size() == 1);
  CHECK(contains_text(talk.question(0), "paint the seat blue"));
  CHECK(contains_text(talk.question(0), shape::write_program(*earlier).dump()));
}

TEST_CASE("The mesh of a program is its shape") {
  Conversation talk({reply_saying(good_stool)});
  MakeRequest request;
  request.description = Conversation::stool();
  const auto shape = talk.maker->generate_mesh(request);
  REQUIRE(shape);
  CHECK(shape->bodies.size() == 5);
}

// As SmolLM2 wrote them.
TEST_CASE("Colours and materials that nobody knows cost no program") {
  Conversation talk({reply_saying(
      R"({"format": "roomgen-shape", "version": 1, "name": "sofa",
          "materials": {"main": {"color": "three-seater", "second": "bar"}},
          "components": [
            {"name": "sofa", "label": "sofa", "box": {"size": [0.4, 0.4, 0.5]}, "material": "main"},
            {"name": "seat", "label": "sofa", "box": {"size": [0.4, 0.4, 0.5]}, "material": "sofa"}],
          "connections": [["sofa", "floor"]]})")});
  const auto program = talk.generate();
  REQUIRE(program);
  CHECK(talk.script->questions.size() == 1);
  CHECK(bodies_of(*program) == 2);
  CHECK(program->materials.size() == 2);
  const auto notes = talk.maker->take_notes();
  CHECK(mentions(notes, "\"three-seater\" is not known"));
  CHECK(mentions(notes, "\"sofa\" was not described"));
}

TEST_CASE("A part that was cut off before its solid is left out, one of an unknown solid asked for again") {
  const std::string whole = R"({"name": "leg", "label": "leg", "box": {"size": [0.4, 0.4, 0.5]}})";
  const auto with = [&](const std::string& more) {
    return R"({"format": "roomgen-shape", "version": 1, "components": [)" + whole + "," + more;
  };
  for (const char* rest : {R"({"name": "seat", "label": "se)", R"({"name": "seat", "box": {"si)"}) {
    Conversation cut({reply_saying(with(rest))});
    const auto program = cut.generate();
    REQUIRE(program);
    CHECK(bodies_of(*program) == 1);
    CHECK(mentions(cut.maker->take_notes(), "\"seat\" has no solid"));
  }

  Conversation unknown(
      {reply_saying(with(R"({"name": "ring", "label": "ring", "torus": {"radius": 1}}]})")),
       reply_saying(good_stool)});
  REQUIRE(unknown.generate());
  CHECK(unknown.script->questions.size() == 2);
}

TEST_CASE("A maker says when its last program was the fallback's") {
  Conversation talk({reply_saying("no"), reply_saying("no"), reply_saying("no"),
                     reply_saying(good_stool)});
  REQUIRE(talk.generate());
  CHECK(talk.maker->fell_back());
  REQUIRE(talk.generate());
  CHECK_FALSE(talk.maker->fell_back());
}

TEST_CASE("A model is asked once for a thing whose size it does not meet to the millimetre") {
  Conversation talk({reply_saying(good_stool)});
  Description wanted = Conversation::stool();
  wanted.size = Vec3(0.42, 0.42, 0.45);
  const auto object = create_described(wanted, *talk.maker);
  REQUIRE(object);
  CHECK(talk.script->questions.size() == 1);
  CHECK_FALSE(object->fell_back);
}
