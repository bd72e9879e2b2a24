#include "roomgen/shape/program.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/shape/primitives.h"
#include "shape_files.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

const std::string parameters =
    R"("parameters": {"w": {"value": 0.4, "min": 0.2, "max": 0.6}, "k": {"value": 3, "min": 1, "max": 9, "integer": true},
       "seat": {"value": "round", "choices": ["round", "square"]}, "paint": {"value": "oak", "color": true}},
       "let": [["half", "w / 2"], ["q", "half * half"]],)";

Json recipe(const std::string& components, const std::string& rest = "") {
  return document(components, parameters + rest);
}

std::string box(const std::string& more) {
  return R"({"name": "a", "box": {"size": ["w", "half", 0.1]})" + more + "}";
}

const Vec3& size_of(const Component& component) {
  return std::get<Box>(component.solid).size;
}

// A document that uses another.
Json user(const std::string& name) {
  return document(R"({"name": "u", "use": ")" + name + "\"}");
}

RecipeSource from(std::map<std::string, Json> recipes) {
  return [recipes](const std::string& name) -> Result<Json> {
    const auto found = recipes.find(name);
    if (found == recipes.end()) return Error{Error::Kind::not_found, "no recipe \"" + name + "\""};
    return found->second;
  };
}

}  // namespace

TEST_CASE("Parameters and lets are put in") {
  const auto program = concrete(recipe(box(R"(, "at": [0, 0, "q + (1 - q) * (seat == square) "])")),
                                {{"w", 0.5}, {"seat", std::string("square")}});
  REQUIRE(program.components.size() == 1);
  CHECK(size_of(program.components[0]) == Vec3(0.5, 0.25, 0.1));
  CHECK(program.components[0].at.z() == 1.0);
}

TEST_CASE("Numbers of a concrete program have six decimals") {
  const auto program =
      concrete(recipe(R"({"name": "a", "box": {"size": ["w / 3", "0.1 + 0.2", 1]}})"));
  CHECK(size_of(program.components[0]) == Vec3(0.133333, 0.3, 1));
}

TEST_CASE("Parameters out of range are refused with the range, and can be clamped") {
  const auto json = recipe(box(""));
  CHECK(refusal(json, {{"w", 0.7}}) ==
        "test: parameter \"w\": 0.7 is out of range; expected a number from 0.2 to 0.6");
  CHECK(contains_text(refusal(json, {{"k", 2.5}}), "expected a whole number from 1 to 9"));
  CHECK(contains_text(refusal(json, {{"seat", std::string("oval")}}), "none of round, square"));
  CHECK(contains_text(refusal(json, {{"seat", 1.0}}), "expected one of round, square"));
  CHECK(contains_text(refusal(json, {{"paint", std::string("dark")}}), "no colour"));
  CHECK(contains_text(refusal(json, {{"w", std::nan("")}}), "out of range"));
  CHECK(contains_text(refusal(json, {{"setat", std::string("round")}}), "did you mean \"seat\"?"));

  const auto described = describe_parameters(json);
  REQUIRE(described);
  REQUIRE(described->size() == 4);
  CHECK((*described)[1].integer);
  const auto values =
      clamped(*described, {{"w", 0.7}, {"k", 2.6}, {"seat", std::string("oval")}, {"x", 1.0}});
  CHECK(values == Values{{"w", 0.6}, {"k", 3.0}, {"seat", std::string("round")}});
  concrete(json, values);
}

TEST_CASE("Parameters that cannot be are refused with their place") {
  const auto error = [](const std::string& text) {
    return refusal(document(box(""), R"("parameters": )" + text + ","));
  };
  CHECK(contains_text(error(R"({"w": {"value": 1, "min": 2, "max": 3}})"),
                      "/parameters/w/value: 1 is out of range"));
  CHECK(contains_text(error(R"({"w": {"value": 1, "min": 2}})"), "/parameters/w/max: missing"));
  CHECK(contains_text(error(R"({"w": {"value": 1, "min": 2, "max": 0}})"), "/parameters/w/min"));
  CHECK(contains_text(error(R"({"w": {"value": "a", "choices": ["b"]}})"),
                      "/parameters/w/value: \"a\" is none of b"));
  CHECK(contains_text(error(R"({"sin": {"value": 1, "min": 0, "max": 3}})"), "meaning of its own"));
  CHECK(contains_text(error(R"({"i": {"value": 1, "min": 0, "max": 3}})"), "meaning of its own"));
  CHECK(contains_text(error(R"({"a b": {"value": 1, "min": 0, "max": 3}})"), "is no name"));
  CHECK(contains_text(error(R"({"w": {"value": 1, "min": 0, "max": 3, "step": 1}})"),
                      "/parameters/w: unknown key"));
  CHECK(contains_text(error("3"), "/parameters: expected an object"));
  const auto let = [](const std::string& text) {
    return refusal(document(box(""), R"("let": )" + text + ","));
  };
  CHECK(
      contains_text(let(R"([["a", "1 / 0"]])"), "/let/0/1: \"1 / 0\": column 3: division by zero"));
  CHECK(contains_text(let(R"([["a", "b"], ["b", "1"]])"), "/let/0/1"));
  CHECK(contains_text(let(R"([["a", 1], ["a", 2]])"), "/let/1/0: \"a\" is already"));
  CHECK(contains_text(let(R"([["a"]])"), "/let/0: expected a name and a formula"));
}

TEST_CASE("Formulas are refused at their place in the recipe") {
  const auto error = [](const std::string& component) { return refusal(recipe(component)); };
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["w +", 1, 1]}})"),
                      "/components/0/box/size/0: \"w +\": column 4"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["wi", 1, 1]}})"),
                      "unknown name \"wi\""));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["w - 1", 1, 1]}})"),
                      "\"w - 1\" is -0.6, out of range; expected a number from 0.0002 to 20"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["seat", 1, 1]}})"),
                      "is the word round"));
  CHECK(contains_text(error(box(R"(, "when": "seat == oval")")), "/components/0/when"));
  CHECK(contains_text(error(box(R"(, "material": "$none")")),
                      "/components/0/material: no parameter"));
  CHECK(contains_text(
      error(box(R"(, "operations": [{"array": {"count": "k / 2", "step": [1, 0, 0]}}])")),
      "1.5 is not whole"));
}

TEST_CASE("A component goes when its condition fails, and its connections with it") {
  const auto json = recipe(
      R"({"name": "a", "box": {"size": [1, 1, 1]}}, {"name": "b", "label": "pad", "when": "seat == square", "box": {"size": [1, "0 - 1", 1]}})",
      R"("connections": [["b", "a"], ["a", "pad"], ["a", "floor"]],)");
  const auto program = concrete(json);
  CHECK(program.components.size() == 1);
  CHECK(program.connections == std::vector<std::pair<std::string, std::string>>{{"a", "floor"}});
}

TEST_CASE("Copies that say i become components of their own, others stay one") {
  const auto same =
      concrete(recipe(box(R"(, "operations": [{"array": {"count": "k", "step": ["w", 0, 0]}}])")));
  REQUIRE(same.components.size() == 1);
  CHECK(std::get<Array>(same.components[0].operations[0]).count == 3);

  const auto differ = concrete(recipe(
      R"({"name": "a", "box": {"size": ["0.1 * i + 0.1", "n", 1]
}
, "at" : [ 1, 0, 0 ], "operations" : [ {"array" : {"count" : "k", "step" : [ "w", 0, 0 ]}} ]
})"));
  REQUIRE(differ.components.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(differ.components[i].name == "a-" + std::to_string(i));
    CHECK(size_of(differ.components[i]).isApprox(Vec3(0.1 * (i + 1), 3, 1)));
    CHECK(differ.components[i].at.isApprox(Vec3(1 + 0.4 * i, 0, 0)));
    CHECK(differ.components[i].operations.empty());
  }
}

TEST_CASE("Copies written out stand where the operation would have put them") {
  for (const char* operation : {R"({"array": {"count": 4, "step": [0.3, 0.1, 0.2]}})",
                                R"({"radial": {"count": 5, "center": [0.3, -0.2], "start": 20}})",
                                R"({"radial": {"count": 4, "angle": 100}})"}) {
    for (const char* after : {"", R"(, {"mirror": "x"}, {"center": "xy"})"}) {
      const auto text = [&](const std::string& height) {
        return R"({"name": "a", "box": {"size": [0.2, 0.1, )" + height +
               R"(]}, "rotate": [10, 20, 30], "scale": [1, -2, 1], "at": [0.5, 0.1, 0.2], "operations": [{"cut": {"point": [0, 0, 0.2], "normal": [0.1, 0, 1]}}, )" +
               operation + after + "]}";
      };
      const auto kept = made(concrete(document(text("0.3"))));
      const auto written = made(concrete(document(text(R"("0.3 + 0 * i")"))));
      INFO(operation << after);
      REQUIRE(kept.bodies.size() == written.bodies.size());
      CHECK(bounds(kept).low.isApprox(bounds(written).low, 1e-4));
      CHECK(bounds(kept).high.isApprox(bounds(written).high, 1e-4));
      if (*after) continue;
      for (std::size_t k = 0; k < kept.bodies.size(); ++k) {
        CHECK(kept.bodies[k].name == written.bodies[k].name);
        CHECK((bounds(kept.bodies[k].mesh).center() - bounds(written.bodies[k].mesh).center())
                  .norm() < 1e-4);
      }
    }
  }
}

TEST_CASE("Inside a group of copies, i is the nearest copy's index and j the one around it") {
  const auto program = concrete(document(
      R"({"name": "row", "operations": [{"array": {"count": 3, "step": [0, 0, 1]}}], "group": {"components": [
         {"name": "book", "box": {"size": ["0.1 + i + 5 * j", 1, 1]}, "operations": [{"array": {"count": 2, "step": [1, 0, 0]}}]}]}})"));
  REQUIRE(program.components.size() == 3);
  const auto& row = std::get<Group>(program.components[2].solid);
  REQUIRE(row.components.size() == 2);
  CHECK(size_of(row.components[1]).x() == Approx(11.1));
}

TEST_CASE("Copies that differ must be made first") {
  CHECK(contains_text(
      refusal(document(
          R"({"name": "a", "box": {"size": ["0.1 + i", 1, 1]}, "operations": [{"mirror": "x"}, {"array": {"count": 2, "step": [1, 0, 0]}}]})")),
      "/components/0/operations/1"));
}

TEST_CASE("A used recipe becomes a group with its materials and connections") {
  const auto program = concrete(document(
      R"({"name": "top", "box": {"size": [1, 1, 0.1]}, "at": [0, 0, 0.5], "material": "m"},
         {"name": "leg", "use": "leg", "with": {"height": 0.5, "style": "turned"}, "materials": {"wood": "m"}})",
      R"("connections": [["leg", "top"]],)"));
  REQUIRE(program.components.size() == 2);
  const auto& group = std::get<Group>(program.components[1].solid);
  REQUIRE(group.components.size() == 2);
  CHECK(group.components[0].name == "turned");
  CHECK(group.components[0].material == "m");
  CHECK(group.components[1].material == "leg.felt");
  CHECK(program.materials.size() == 2);
  CHECK(program.connections ==
        std::vector<std::pair<std::string, std::string>>{
            {"leg", "top"}, {"leg.leg", "leg.glide"}, {"leg.glide", "floor"}});
  CHECK(read_program(write_program(program), "again"));

  const auto painted = concrete(document(R"({"name": "leg", "use": "leg", "material": "m"})"));
  CHECK(painted.materials.size() == 1);
}

TEST_CASE("Errors about used recipes name the place of use and the place in the recipe") {
  const auto error = [](const std::string& component, const RecipeSource& source) {
    return refusal(document(component), {}, source);
  };
  const auto leg = from({{"leg", shape_file("leg")}});
  CHECK(contains_text(error(R"({"name": "a", "use": "legg"})", leg),
                      "/components/0/use: no recipe \"legg\""));
  CHECK(contains_text(error(R"({"name": "a", "use": "leg"})", nullptr), "no other recipes"));
  CHECK(contains_text(
      error(R"({"name": "a", "use": "leg", "with": {"height": 5}})", leg),
      "/components/0/with/height: 5 is out of range; expected a number from 0.05 to 1.2"));
  CHECK(contains_text(error(R"({"name": "a", "use": "leg", "with": {"hight": 1}})", leg),
                      "/components/0/with/hight"));
  CHECK(contains_text(error(R"({"name": "a", "use": "leg", "materials": {"steel": "m"}})", leg),
                      "no material \"steel\""));
  CHECK(contains_text(error(R"({"name": "a", "use": "leg", "materials": {"wood": "x"}})", leg),
                      "/components/0/materials/wood"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": [1, 1, 1]}, "with": {}})", leg),
                      "/components/0/with"));
  auto broken = shape_file("leg");
  broken["components"][2]["cylinder"]["radius"] = "nothing";
  CHECK(contains_text(
      error(R"({"name": "a", "use": "leg"})", from({{"leg", broken}})),
      "/components/0/use: recipe \"leg\": /components/2/cylinder/radius: \"nothing\""));
  CHECK(contains_text(error(R"({"name": "a", "use": "../leg"})", recipes_in(shapes_folder)),
                      "no name of a recipe"));
}

TEST_CASE("Recipes in a circle and too deep are refused with the chain") {
  CHECK(contains_text(refusal(user("a"), {}, from({{"a", user("b")}, {"b", user("a")}})),
                      "in a circle: a > b > a"));
  std::map<std::string, Json> chain;
  for (int k = 0; k < 12; ++k) chain["r" + std::to_string(k)] = user("r" + std::to_string(k + 1));
  CHECK(contains_text(refusal(user("r0"), {}, from(chain)), "more than 8 deep: r0 > r1"));
  chain["r8"] = document(R"({"name": "x", "box": {"size": [1, 1, 1]}})");
  CHECK_FALSE(instantiate(user("r0"), {}, 0, from(chain)));
  chain["r7"] = chain["r8"];
  CHECK(instantiate(user("r0"), {}, 0, from(chain)));
}

TEST_CASE("What would grow without bound is refused, soon") {
  std::map<std::string, Json> recipes;
  const std::string ten = R"("operations": [{"array": {"count": 10, "step": ["0.01 * i", 0, 0]}}])";
  for (int k = 0; k < 8; ++k)
    recipes["r" + std::to_string(k)] =
        document(R"({"name": "u", "use": "r)" + std::to_string(k + 1) +
                 "\", \"at\": [\"i\", 0, 0], " + ten + "}");
  recipes["r7"] = document(R"({"name": "x", "box": {"size": [1, 1, 1]}})");
  CHECK(contains_text(refusal(user("r0"), {}, from(recipes)), "more than 4096 components"));
  // Nothing but dropped components.
  for (int k = 0; k < 8; ++k) recipes["r" + std::to_string(k)]["components"][0]["when"] = "i >= 0";
  recipes["r7"] = document(R"({"name": "x", "when": 0, "box": {"size": [1, 1, 1]}})");
  CHECK_FALSE(refusal(user("r0"), {}, from(recipes)).empty());

  std::string deep = R"({"name": "x", "box": {"size": ["0.1 + i", 1, 1]}, )" + ten + "}";
  for (int k = 0; k < 6; ++k)
    deep =
        R"({"name": "g", "at": ["i", 0, 0], "group": {"components": [)" + deep + "]}, " + ten + "}";
  CHECK_FALSE(refusal(document(deep)).empty());
  Json buried = document("");
  for (int k = 0; k < 40; ++k) buried["name"] = Json::array({buried["name"]});
  CHECK(contains_text(refusal(buried), "nested more than 32 deep"));
  CHECK(contains_text(
      refusal(document(
          R"({"name": "a", "box": {"size": ["i", 1, 1]}, "operations": [{"array": {"count": 1000000, "step": [1, 0, 0]}}]})")),
      "/operations/0/array/count"));
  const auto large = parse_recipe(std::string((1u << 20) + 1, ' '), "big.json");
  REQUIRE_FALSE(large);
  CHECK(contains_text(large.error().message, "big.json: a shape program of more than 1 MB"));
}

TEST_CASE("Equal seeds give equal programs, others differ") {
  const auto json = shape_file("bookshelf");
  const auto text = [&](std::uint64_t seed) {
    return dump_json(write_program(concrete(json, {}, seed)));
  };
  CHECK(text(3) == text(3));
  CHECK(text(3) != text(4));
}

TEST_CASE("A colour, a theme and a material may be a parameter") {
  auto json = recipe(box(R"(, "material": "m")"));
  json["materials"]["m"] = {{"color", "$paint"}, {"roughness", "w"}};
  const auto program = concrete(json, {{"paint", std::string("#112233")}});
  CHECK(program.materials[0].color == "#112233");
  CHECK(program.materials[0].roughness == Approx(0.4));
}

TEST_CASE("Every example is within its limits over its parameters' whole range") {
  for (const auto& name : shape_names) {
    const auto json = shape_file(name);
    const auto described = describe_parameters(json);
    REQUIRE(described);
    for (const auto& parameter : *described) {
      std::vector<Value> tried(parameter.choices.begin(), parameter.choices.end());
      if (tried.empty() && !parameter.color) tried = {parameter.min, parameter.max};
      for (const auto& value : tried) {
        INFO(name << " " << parameter.name << " = " << to_text(value));
        const auto shape = made(concrete(json, {{parameter.name, value}}));
        for (const auto& body : shape.bodies) CHECK(is_closed(body.mesh));
      }
    }
  }
}
