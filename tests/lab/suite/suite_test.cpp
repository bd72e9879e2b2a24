#include <nlohmann/json.hpp>

#include "roomgen/lab/suite.h"

#include "create/programs.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace roomgen::create;

namespace {

SuiteSentence sentence(const std::string& json) {
  const auto parsed = parse_json("[" + json + "]", "test");
  REQUIRE(parsed);
  const auto suite = read_suite(*parsed, "test");
  INFO((suite ? "" : suite.error().message));
  REQUIRE(suite);
  return suite->front();
}

const std::string stool_words =
    R"({"prompt": "a stool on four legs", "group": "common", "mount": "floor",
        "parts": [{"label": "seat", "count": 1}, {"label": "leg", "count": 4}],
        "size": [[0.3, 0.5], [0.3, 0.5], [0.4, 0.5]]})";

const std::string seat_part =
    R"({"name": "seat", "label": "seat", "box": {"size": [0.4, 0.4, 0.03]}, "at": [0, 0, 0.42]})";

std::string leg(const std::string& name, double x, double y, double height = 0.42) {
  return R"({"name": ")" + name + R"(", "label": "leg", "box": {"size": [0.04, 0.04, )" +
         std::to_string(height) + "]}, \"at\": [" + std::to_string(x) + ", " + std::to_string(y) +
         ", 0]}";
}

const std::string four_legs = leg("leg-1", -0.17, -0.17) + "," + leg("leg-2", 0.17, -0.17) + "," +
                              leg("leg-3", -0.17, 0.17) + "," + leg("leg-4", 0.17, 0.17);

CreatedObject made(const shape::Program& program) {
  CreatedObject object;
  object.program = program;
  const auto shape = shape::evaluate(program);
  REQUIRE(shape);
  object.shape = *shape;
  return object;
}

Assessment assessed(const std::string& components, const std::string& words = stool_words) {
  return assess(sentence(words), made(program(components)));
}

// Exactly these checks fail; parts are all right.
void fails_only(const Assessment& found, const std::vector<Check>& expected) {
  for (std::size_t k = 0; k < check_count; ++k) {
    const auto check = static_cast<Check>(k);
    const bool failed = found[check] == false;
    const bool should = std::find(expected.begin(), expected.end(), check) != expected.end();
    INFO(name(check));
    for (const auto& failure : found.failures) UNSCOPED_INFO(failure);
    CHECK(failed == should);
  }
  CHECK(found.perfect() == expected.empty());
}

}  // namespace

TEST_CASE("A sound stool passes every check") {
  const auto found = assessed(seat_part + "," + four_legs);
  fails_only(found, {});
  CHECK(found.failures.empty());
  CHECK(found.parts_right == 2);
  CHECK(found[Check::symmetric] == true);
}

TEST_CASE("A seat that floats is a loose part that rests on nothing") {
  const std::string high =
      R"({"name": "seat", "label": "seat", "box": {"size": [0.4, 0.4, 0.03]}, "at": [0, 0, 0.43]})";
  fails_only(assessed(high + "," + four_legs), {Check::connected, Check::supported});
}

TEST_CASE("A thing in the air, or a leg of it, has no contact with the ground") {
  shape::Program lifted = program(seat_part + "," + four_legs);
  for (auto& component : lifted.components) component.at.z() += 0.02;
  fails_only(assess(sentence(stool_words), made(lifted)), {Check::grounded});

  lifted = program(seat_part + "," + four_legs);
  lifted.components[1].at.z() += 0.025;
  fails_only(assess(sentence(stool_words), made(lifted)), {Check::grounded});
}

TEST_CASE("Legs of two lengths, in one place or askew are not symmetric") {
  const std::string three = leg("leg-1", -0.17, -0.17) + "," + leg("leg-2", 0.17, -0.17) + "," +
                            leg("leg-3", -0.17, 0.17) + ",";
  fails_only(assessed(seat_part + "," + three + leg("leg-4", 0.17, 0.1)), {Check::symmetric});
  fails_only(assessed(seat_part + "," + three + leg("leg-4", -0.17, 0.17)), {Check::symmetric});
  fails_only(assessed(seat_part + "," + three + leg("leg-4", 0.17, 0.17, 0.44)), {Check::symmetric});
  // Three in a ring are even.
  const std::string ring =
      seat_part + R"(,{"name": "leg", "label": "leg", "cylinder": {"radius": 0.02, "height": 0.42},
                  "at": [0.15, 0, 0], "operations": [{"radial": {"count": 3}}]})";
  CHECK(assessed(ring)[Check::symmetric] == true);
}

TEST_CASE("A leg that ends beside what it carries is no support") {
  const std::string beside = seat_part + "," + leg("leg-1", -0.17, -0.17) + "," +
                             leg("leg-2", 0.17, -0.17) + "," + leg("leg-3", -0.23, 0.17, 0.425) +
                             "," + leg("leg-4", 0.23, 0.17, 0.425);
  const auto found = assessed(beside);
  CHECK(found[Check::supported] == false);
  CHECK(found[Check::stable] == true);
}

TEST_CASE("What leans too far falls, and what is too large is told by its sides") {
  const std::string tower =
      leg("leg-1", 0, 0) +
      R"(,{"name": "seat", "label": "seat", "box": {"size": [0.7, 0.4, 0.03]}, "at": [0.3, 0, 0.42]})";
  const auto found = assessed(tower);
  CHECK(found[Check::stable] == false);
  CHECK(found[Check::size] == false);
  CHECK(contains_text(found.failures.back(), "width 0.7 m, not 0.3 to 0.5"));
  CHECK(found.parts_right == 1);
}

TEST_CASE("Parts count by the last word of their label, in ranges, and as groups of others") {
  const std::string words = R"({"prompt": "x", "mount": "floor", "size": [[0, 9], [0, 9], [0, 9]],
      "parts": [{"label": "leg", "count": [4, 6]}, {"label": "armrest", "count": 0},
                {"label": "back|rest", "count": null}, {"label": "leg", "count": 3}]})";
  const std::string components = four_legs + "," +
                                 R"({"name": "back", "label": "back", "group": {"components": [
      {"name": "post", "label": "post", "box": {"size": [0.1, 0.1, 0.1]}}]}},
      {"name": "fifth", "label": "middle leg", "box": {"size": [0.1, 0.1, 0.1]}})";
  const auto found = assess(sentence(words), made(program(components)));
  CHECK(found.parts_asked == 4);
  CHECK(found.parts_right == 3);
  CHECK(contains_text(found.failures.front(), "leg: 5, not 3"));
}

TEST_CASE("Pieces that were joined to one body must touch all the same") {
  const std::string words = R"({"prompt": "x", "mount": "floor", "parts": [],
      "size": [[0, 9], [0, 9], [0, 9]]})";
  const auto joined = [&](double step) {
    return assess(sentence(words),
                  made(program(R"({"name": "a", "label": "a", "box": {"size": [0.2, 0.2, 0.2]},
          "operations": [{"array": {"count": 2, "step": [)" +
                               std::to_string(step) + R"(, 0, 0]}}, {"join": true}]})")));
  };
  CHECK(joined(0.2)[Check::connected] == true);
  CHECK(joined(0.21)[Check::connected] == false);
}

TEST_CASE("Triangles without a program are judged like those of one") {
  auto object = made(program(seat_part + "," + four_legs));
  object.program = {};
  fails_only(assess(sentence(stool_words), object), {});
  for (auto& position : object.shape.bodies.front().mesh.positions) position.z() += 0.01f;
  fails_only(assess(sentence(stool_words), object), {Check::connected, Check::supported});
}

TEST_CASE("A sentence that was made as two things is not one body") {
  Creation creation;
  creation.objects = {made(program(seat_part + "," + four_legs))};
  fails_only(assess(sentence(stool_words), creation), {});
  creation.objects.front().description.count = 2;
  fails_only(assess(sentence(stool_words), creation), {Check::connected});
  creation.objects.front().description.count = 1;
  creation.objects.push_back(creation.objects.front());
  fails_only(assess(sentence(stool_words), creation), {Check::connected});
}

TEST_CASE("What hangs is asked neither for ground nor for balance") {
  const std::string words = R"({"prompt": "x", "mount": "wall", "parts": [],
      "size": [[0, 9], [0, 9], [0, 9]]})";
  auto board = program(
      R"({"name": "board", "label": "board", "box": {"size": [0.8, 0.2, 0.02]}, "at": [0, 0, 1.5]})");
  const auto found = assess(sentence(words), made(board));
  for (const Check check : {Check::grounded, Check::supported, Check::stable})
    CHECK_FALSE(found[check].has_value());
  CHECK(found[Check::connected] == true);
  CHECK(found.perfect());
  CHECK_FALSE(not_made(sentence(words), "why")[Check::stable].has_value());
}

TEST_CASE("The validator and the score agree on what holds together and stands") {
  for (const auto& sound : {curved_table(), turned_table(), dresser(), runged_stool()}) {
    const auto found = assess(sentence(stool_words), made(sound));
    for (const Check check : {Check::connected, Check::grounded, Check::supported, Check::stable}) {
      INFO(name(check) << " " << join(found.failures, "; "));
      CHECK(found[check] == true);
    }
  }
}

TEST_CASE("What cannot be a suite is refused with its place") {
  for (const auto& [json, place] : std::vector<std::pair<std::string, std::string>>{
           {"[]", "no sentences"},
           {"{}", "array"},
           {R"([{"prompt": "x", "parts": [], "mount": "roof", "size": [[0, 1], [0, 1], [0, 1]]}])",
            "/0/mount"},
           {R"([{"prompt": "x", "parts": [], "size": [[0, 1], [0, 1]]}])", "/0/size"},
           {R"([{"prompt": "x", "parts": [{"label": "leg", "count": -1}],
                 "size": [[0, 1], [0, 1], [0, 1]]}])",
            "/0/parts/0/count"}}) {
    const auto suite = read_suite(*parse_json(json, "test"), "test");
    REQUIRE_FALSE(suite);
    INFO(suite.error().message);
    CHECK(contains_text(suite.error().message, place));
  }
  const std::string file = ROOMGEN_SOURCE_DIR "/bench/create/prompts.json";
  const auto suite = read_suite(*parse_json(*read_file(file), file), file);
  REQUIRE(suite);
  CHECK(suite->size() == 150);
}

TEST_CASE("A result comes back from its line, and tables count what was not made as failed") {
  SuiteResult good;
  good.number = 1;
  good.prompt = "a stool on four legs";
  good.group = "common";
  good.assessment = assessed(seat_part + "," + four_legs);
  good.size = Vec3(0.4, 0.4, 0.45);
  good.scores = Scores{{5, "firm"}, {4, ""}, {3, "no oak"}};
  SuiteResult bad = good;
  bad.number = 2;
  bad.scores.reset();
  bad.assessment = not_made(sentence(stool_words), "no words");
  bad.fell_back = true;
  for (const auto& result : {good, bad}) {
    const auto back = suite_result_from_json(to_json(result), "line");
    INFO((back ? "" : back.error().message));
    REQUIRE(back);
    CHECK(to_json(*back) == to_json(result));
  }
  const Json all = suite_summary({good, bad})["full"]["all"];
  CHECK(all["made"] == Json{{"right", 1}, {"of", 2}});
  CHECK(all["parts_right"] == Json{{"right", 2}, {"of", 4}});
  CHECK(all["stable"] == Json{{"right", 1}, {"of", 2}});
  CHECK(all["everything"] == Json{{"right", 1}, {"of", 2}});
  CHECK(all["scores"]["judged"] == 1);
  CHECK(all["scores"]["alignment"] == 3.0);
  const std::string text = suite_markdown({good, bad});
  CHECK(contains_text(text, "| full | all | 2 | 50 % |"));
  CHECK(contains_text(text, "| 5 | 4 | 3 |"));
  CHECK(contains_text(text, "- full 002 a stool on four legs: not made: no words"));
}
