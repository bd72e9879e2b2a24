// Whatever a model answers: no crash, no endless work, and the fallback stands ready.
#include <chrono>

#include "base/random.h"
#include "conversation.h"
#include "create/kinds.h"
#include "roomgen/create/maker.h"

using namespace conversation;

namespace {

std::string with_component(const std::string& component, const std::string& rest = "") {
  return R"({"format": "roomgen-shape", "version": 1, "name": "x",)" + rest + R"("components": [)" +
         component + "]}";
}

std::string repeated(const std::string& text, std::size_t times, const std::string& between = "") {
  std::string result;
  for (std::size_t k = 0; k < times; ++k) result += (k ? between : "") + text;
  return result;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("Hostile programs end with the fallback, and soon") {
  const std::string box = R"({"name": "a", "box": {"size": [1, 1, 1]})";
  const std::string tenfold = R"({"array": {"count": 10, "step": [0, 0, 0.1]}})";
  const std::vector<std::string> answers = {
      with_component(R"({"name": "a", "box": {"size": [NaN, 1, 1]}})"),
      with_component(R"({"name": "a", "box": {"size": [1e999, 1, 1]}})"),
      with_component(R"({"name": "a", "box": {"size": ["0 / 0", 1, 1]}})"),
      with_component(R"({"name": "a", "box": {"size": [1000, 600, 700]}})"),
      with_component(R"({"name": "a", "box": {"size": [18, 1, 1]}})"),
      with_component(R"({"name": "a", "dodecahedron": {"size": [1, 1, 1]}})"),
      with_component(box +
                     R"(, "operations": [{"array": {"count": 1000000, "step": [0, 0, 1]}}]})"),
      with_component(box + R"(, "operations": [)" + repeated(tenfold, 6, ",") + "]}"),
      with_component(R"({"name": "a", "use": "../../../etc/passwd"})"),
      with_component(R"({"name": "a", "use": "a"})"),
      with_component(R"({"name": "a", "box": {"size": ["x", 1, 1]}})",
                     R"("let": [["x", "y"], ["y", "x"]],)"),
      with_component(R"({"name": "a", "box": {"size": [")" + repeated("(", 400) + R"(", 1, 1]}})"),
      with_component(R"({"name": "a", "box": {"size": [")" + repeated("1+", 100000) +
                     R"(1", 1, 1]}})"),
      with_component(
          R"({"name": "a", "height_field": {"size": [1, 1], "height": "u +", "divisions": 1e9}})"),
      with_component(R"({"name": "a", "sweep": {"path": [)" + repeated("[0, 0, 0]", 5000, ",") +
                     R"(], "radius": 0.1}})"),
      repeated(R"({"components": [)", 10000),
      repeated("[", 100000),
      R"({"components": "all of them"})",
      R"({"components": {"a": 1, "b": []}})",
      R"({"components": [null, 3, "leg"], "materials": 7, "connections": {"a": "b"}})",
      R"({"components": []})",
      std::string("{\"components\": [\"\0\xff\xfe\"]}", 24),
      std::string(1u << 21, '{')};
  for (const auto& answer : answers) {
    INFO(answer.substr(0, 200));
    const auto start = std::chrono::steady_clock::now();
    Conversation talk({reply_saying(answer), reply_saying(answer), reply_saying(answer)});
    const auto program = talk.generate();
    REQUIRE(program);
    CHECK(program->name == "box");
    CHECK(talk.script->questions.size() == 3);
    CHECK(seconds_since(start) < 5.0);
  }
}

TEST_CASE("Groups in groups without end are no danger") {
  std::string nested = R"({"name": "a", "box": {"size": [1, 1, 1]}})";
  for (int k = 0; k < 5000; ++k)
    nested = R"({"name": "g", "group": {"components": [)" + nested + "]}}";
  Conversation talk({reply_saying(with_component(nested))});
  CHECK(talk.generate());
}

TEST_CASE("Large programs take bounded time, whether they are read or not") {
  const std::string one = R"({"name":"a","sphere":{"radius":0.1},"material":"oak wood"})";
  const std::vector<std::string> answers = {
      with_component(repeated(one, 15000, ",")),
      with_component(repeated(one, 4000, ",")),
      with_component(one, R"("connections": [)" + repeated(R"(["a", "a-1"])", 50000, ",") + "],"),
      with_component("{" + repeated(R"("k": 1)", 50000, ",") + "}"),
      with_component(one, R"("materials": {)" + repeated(R"("a b": "oak")", 50000, ",") + "},"),
      "{" + repeated(R"("k": 1)", 50000, ",") + R"(, "components": []})"};
  for (const auto& answer : answers) {
    INFO(answer.substr(0, 100));
    const auto start = std::chrono::steady_clock::now();
    Conversation talk({reply_saying(answer), reply_saying(answer), reply_saying(answer)});
    CHECK(talk.generate());
    CHECK(seconds_since(start) < 30.0);
  }
}

TEST_CASE("Damaged answers of every step never crash") {
  const std::string sources[] = {
      good_stool, R"({"objects": [{"object": "stool", "size_cm": [40, 40, 45], "parts":
        [{"label": "leg", "count": 3, "touches": ["seat"]}]}]})",
      R"({"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 1]], "triangles": [[0, 1, 2]],
          "parts": [{"label": "a", "first": 0, "count": 1}]})"};
  const std::string bytes = "{}[]\",:-0e9.\\\n\x80 ";
  ModelMakerOptions direct;
  direct.variant = Variant::direct;
  for (int round = 0; round < 200; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    std::vector<std::string> damaged;
    for (std::string text : sources) {
      for (int k = random.integer(1, 6); k > 0; --k) {
        const auto at =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
        text[at] =
            bytes[static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1))];
      }
      damaged.push_back(text);
    }
    CHECK(Conversation({reply_saying(damaged[0])}).generate());
    CHECK(Conversation({reply_saying(damaged[1])}).maker->decompose("a stool"));
    MakeRequest request;
    CHECK(Conversation({reply_saying(damaged[2])}, direct).maker->generate_mesh(request));
  }
}

// SmolLM2 described a desk of the material "desk", three of it, whose colour is "chair".
TEST_CASE("Whatever words a model describes a thing with, rules make one of it") {
  Description rubbish;
  rubbish.prompt = "I need a desk";
  rubbish.noun = rubbish.material = rubbish.style = "desk";
  rubbish.color = "chair";
  rubbish.count = 3;
  rubbish.size = Vec3(1.2, 0.35, 0.4);
  for (const char* label : {"desk", "leg", "floor", "floor", "-", "drawer"}) {
    PartWish wish = part(label, 3);
    wish.shape = wish.construction = wish.material = wish.color = "chair";
    wish.course = Course::s_curve;
    wish.direction = "straight";
    wish.size = Vec3(1.2, 0.35, 0.4);
    wish.touches = {"leg", "floor", "leg", "nothing"};
    rubbish.parts.push_back(wish);
  }
  const auto rules = make_rule_maker();
  REQUIRE(ShapeKinds::built_in());
  int kinds = 0;
  for (const auto& [name, kind] : ShapeKinds::built_in()->all()) {
    if (++kinds % 4 != 0) continue;  // they share recipes
    INFO(name);
    rubbish.kind = name;
    MakeRequest request;
    request.description = rubbish;
    const auto program = rules->generate(request);
    INFO((program ? "" : program.error().message));
    REQUIRE(program);
    CHECK(shape::evaluate(*program, {.tolerance = 0.01, .paint = false}));
  }
  CHECK(kinds > 20);
}
