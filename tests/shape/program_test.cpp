#include <nlohmann/json.hpp>

#include "roomgen/shape/program.h"

#include "roomgen/base/json.h"
#include "shape_files.h"
#include "support/contains.h"

using namespace roomgen;
using namespace roomgen::shape;

namespace {

std::string read_error(const Json& json) {
  const auto program = read_program(json, "test");
  INFO(json.dump());
  REQUIRE_FALSE(program);
  return program.error().message;
}

// One of every solid and operation.
const char* const everything = R"(
 {"name": "a", "label": "top", "box": {"size": [1, 2, 0.3], "bevel": 0.01}, "scale": [1, -1, 2], "rotate": [10, 20, 33.333333], "at": [0.1, 0, -0.2], "material": "m"},
 {"name": "b", "cylinder": {"radius": 0.1, "height": 0.2}, "operations": [{"array": {"count": 3, "step": [0.3, 0, 0]}}, {"mirror": "y"}, {"join": true}]},
 {"name": "c", "frustum": {"bottom_radius": 0.1, "top_radius": 0, "height": 0.2}, "operations": [{"radial": {"count": 5, "center": [0.5, 0], "angle": 120, "start": 7}}]},
 {"name": "d", "ellipsoid": {"size": [0.1, 0.2, 0.3]}, "operations": [{"cut": {"point": [0, 0, 0.1], "normal": [0, 0, 1]}}, {"center": "xy"}, {"ground": true}]},
 {"name": "e", "prism": {"sides": 5, "radius": 0.1, "height": 0.2}},
 {"name": "f", "plane": {"size": [1, 2], "thickness": 0.002}},
 {"name": "g", "lathe": {"profile": [[0, 0], [0.1, 0], [0.05, 0.2], [0, 0.3]], "corners": [0, 1, 3], "angle": 200}},
 {"name": "h", "sweep": {"path": [[0, 0, 0], [0, 0, 1], [1, 0, 1]], "corners": "all", "section": [0.02, 0.03], "bevel": 0.002, "taper": 0.5, "twist": 45}},
 {"name": "i", "sweep": {"path": [[0, 0, 0], [0, 0, 1]], "outline": [[0, 0], [0.1, 0], [0, 0.1]], "outline_corners": "all"}},
 {"name": "j", "extrude": {"outline": [[0, 0], [1, 0], [1, 1], [0, 1]], "corners": "all", "holes": [{"outline": [[0.2, 0.2], [0.5, 0.2], [0.2, 0.5]]}], "height": 0.1}},
 {"name": "k", "loft": {"levels": [{"z": 0, "size": [0.2, 0.3], "round": 0.5}, {"z": 0.4, "outline": [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]], "corners": [0, 2]}], "straight": true}},
 {"name": "l", "height_field": {"size": [1, 1], "height": "0.1 + 0.05 * sin(90 * u) * v", "divisions": 8, "most": 0.14}},
 {"name": "m", "leaf": {"length": 0.2, "width": 0.08, "thickness": 0.001, "bend": 30, "fold": 10, "widest": 0.4}},
 {"name": "n", "cushion": {"size": [0.5, 0.5, 0.15], "softness": 0.3}},
 {"name": "o", "picture": {"size": [0.5, 0.4], "thickness": 0.02, "drawing": {"ground": ["cream", "#123456"], "shapes": [{"use": "whale", "size": 0.8, "colors": ["navy", "white"]}, {"line": [[0, 0], [1, 1]], "stroke": "red", "width": 0.02, "repeat": {"count": 3, "step": [0.1, 0]}}]}, "seed": 4}},
 {"name": "o2", "text": {"words": "HI", "height": 0.1, "fit": [0.5, 0], "radius": 0.005}},
 {"name": "p", "label": "drawer", "group": {"components": [{"name": "front", "box": {"size": [0.4, 0.02, 0.2]}}, {"name": "knob", "ellipsoid": {"size": [0.02, 0.02, 0.02]}}]}, "material": "m"})";

}  // namespace

TEST_CASE("A written program reads back to the same bytes") {
  const auto first = read_program(
      document(
          everything,
          R"("name": "x", "about": "y", "connections": [["a", "b"], ["top", "floor"], ["p.knob", "p.front"]],)"),
      "test");
  INFO((first ? "" : first.error().message));
  REQUIRE(first);
  const std::string text = dump_json(write_program(*first));
  const auto second = read_program(parsed(text), "test");
  INFO((second ? text : second.error().message));
  REQUIRE(second);
  CHECK(dump_json(write_program(*second)) == text);
  CHECK(second->components.size() == 17);
  CHECK(second->connections.size() == 3);
}

TEST_CASE("A recipe's concrete program round-trips and makes the same bodies") {
  for (const auto& name : shape_names) {
    INFO(name);
    const auto program = concrete(shape_file(name), {}, 5);
    const std::string text = dump_json(write_program(program));
    const auto again = read_program(parsed(text), name);
    INFO((again ? "" : again.error().message));
    REQUIRE(again);
    CHECK(dump_json(write_program(*again)) == text);
    CHECK(triangle_count(made(*again)) == triangle_count(made(program)));
  }
}

TEST_CASE("Errors of a concrete program name the place") {
  const auto error = [](const std::string& component) { return read_error(document(component)); };
  CHECK(error(R"({"name": "a", "box": {"size": [1, 2]}})") ==
        "test: /components/0/box/size: expected an array of 3 numbers");
  CHECK(contains_text(
      error(R"({"name": "a", "box": {"size": [1, 2, 21]}})"),
      "/components/0/box/size/2: 21 is out of range; expected a number from 0.0002 to 20"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": [1, 2, 3], "bevle": 1}})"),
                      "/components/0/box: unknown key \"bevle\"; did you mean \"bevel\"?"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["w", 2, 3]}})"),
                      "/components/0/box/size/0: expected a number"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": ["w", 2, 3]}})"),
                      "formulas belong in recipes"));
  CHECK(contains_text(error(R"({"name": "a", "use": "leg"})"), "belongs in recipes"));
  CHECK(contains_text(error(R"({"name": "a", "when": "1", "box": {"size": [1, 1, 1]}})"),
                      "belongs in recipes"));
  CHECK(contains_text(error(R"({"name": "a"})"), "/components/0: has no solid"));
  CHECK(contains_text(
      error(R"({"name": "a", "box": {"size": [1, 1, 1]}, "ellipsoid": {"size": [1, 1, 1]}})"),
      "more than one solid (box, ellipsoid)"));
  CHECK(contains_text(error(R"({"box": {"size": [1, 1, 1]}})"), "/components/0/name: missing"));
  CHECK(
      contains_text(error(R"({"name": "a.b", "box": {"size": [1, 1, 1]}})"), "/components/0/name"));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": [1, 1, 1]}, "material": "n"})"),
                      "/components/0/material: no material \"n\""));
  CHECK(contains_text(error(R"({"name": "a", "box": {"size": [1, 1, 1]}, "scale": 0})"),
                      "/components/0/scale"));
  CHECK(contains_text(
      error(R"({"name": "a", "box": {"size": [1, 1, 1]}, "operations": [{"mirror": "z"}]})"),
      "/components/0/operations/0/mirror: expected \"x\" or \"y\""));
  CHECK(contains_text(
      error(
          R"({"name": "a", "box": {"size": [1, 1, 1]}, "operations": [{"mirror": "x", "join": true}]})"),
      "expected exactly one"));
  CHECK(contains_text(
      error(
          R"({"name": "a", "box": {"size": [1, 1, 1]}, "operations": [{"cut": {"point": [0,0,0], "normal": [0,0,0]}}]})"),
      "/components/0/operations/0/cut/normal"));
  CHECK(contains_text(
      error(
          R"({"name": "a", "sweep": {"path": [[0,0,0],[0,0,1]], "radius": 0.1, "section": [1, 1]}})"),
      "expected one of \"radius\", \"section\" and \"outline\""));
  CHECK(contains_text(error(R"({"name": "a", "lathe": {"profile": [[0, 0], [-1, 1]]}})"),
                      "negative"));
  CHECK(
      contains_text(error(R"({"name": "a", "lathe": {"profile": [[0, 0]]}})"), "2 points or more"));
  CHECK(contains_text(
      error(R"({"name": "a", "lathe": {"profile": [[0, 0], [1, 1]], "corners": [2]}})"),
      "/corners/0"));
  CHECK(contains_text(
      error(
          R"({"name": "a", "loft": {"levels": [{"z": 1, "size": [1, 1]}, {"z": 1, "size": [1, 1]}]}})"),
      "not above"));
  CHECK(contains_text(
      error(R"({"name": "a", "height_field": {"size": [1, 1], "height": "w * u"}})"), "/height"));
  CHECK(contains_text(error(R"({"name": "a", "picture": {"size": [1, 1], "theme": "letters"}})"),
                      "there are screen"));
  CHECK(contains_text(
      error(R"({"name": "a", "group": {"components": [{"name": "b", "box": {"size": 3}}]}})"),
      "/components/0/group/components/0/box/size"));
  CHECK(contains_text(
      error(R"({"name": "a", "box": {"size": [1,1,1]}}, {"name": "a", "box": {"size": [1,1,1]}})"),
      "two components are called \"a\""));
}

TEST_CASE("Errors of the document around the components name the place") {
  const std::string box = R"({"name": "a", "box": {"size": [1, 1, 1]}})";
  CHECK(contains_text(read_error(parsed("[]")), "expected a shape program"));
  CHECK(contains_text(read_error(parsed("{}")), "\"format\" must be \"roomgen-shape\""));
  CHECK(contains_text(read_error(parsed(R"({"format": "roomgen-shape"})")), "/components"));
  CHECK(contains_text(read_error(document(box, R"("parameters": {},)")), "a recipe"));
  CHECK(contains_text(read_error(document(box, R"("part": {},)")), "unknown key \"part\""));
  CHECK(contains_text(read_error(document(box, R"("connections": [["a", "c"]],)")),
                      "/connections/0/1: no component"));
  CHECK(contains_text(read_error(document(box, R"("connections": [["a"]],)")),
                      "/connections/0: expected two names"));
  CHECK(contains_text(read_error(document(box, R"("connections": [["floor", "a"]],)")),
                      "/connections/0/0"));
  auto colored = document(box);
  colored["materials"]["m"]["color"] = "okk";
  CHECK(contains_text(read_error(colored), "/materials/m/color: \"okk\" is no colour; "));
  colored["materials"]["m"] = {{"color", "#12345"}};
  CHECK(contains_text(read_error(colored), "/materials/m/color"));
  colored["materials"]["m"] = {{"color", "#123456"}, {"pattern", "dots"}};
  CHECK(contains_text(read_error(colored), "/materials/m/pattern: no pattern"));
  colored["materials"]["m"] = {{"color", "#123456"}, {"roughness", 2}};
  CHECK(contains_text(read_error(colored), "/materials/m/roughness: 2 is out of range"));
}

TEST_CASE("Copies beyond the limit are refused before they are made") {
  const auto copies = [](const std::string& operations) {
    return read_error(document(R"({"name": "a", "box": {"size": [1, 1, 1]}, "operations": [)" +
                               operations + "]}"));
  };
  CHECK(contains_text(copies(R"({"array": {"count": 1000000, "step": [1, 0, 0]}})"),
                      "/operations/0/array/count"));
  const std::string hundred = R"({"array": {"count": 100, "step": [0.01, 0, 0]}})";
  CHECK(contains_text(copies(hundred + "," + hundred), "more than 4096 components"));
  std::string nested = R"({"name": "a", "box": {"size": [1, 1, 1]}})";
  for (int k = 0; k < 8; ++k)
    nested = R"({"name": "g", "group": {"components": [)" + nested + R"(]}, "operations": [)" +
             hundred + "]}";
  CHECK(contains_text(read_error(document(nested)), "more than 4096 components"));
}

TEST_CASE("A reference means a part, its copies and what is in it, or a label") {
  CHECK(refers_to("leg", "leg", ""));
  CHECK(refers_to("leg", "leg-3", ""));
  CHECK(refers_to("leg-3", "leg-3", ""));
  CHECK(refers_to("drawer", "drawer-2.handle", ""));
  CHECK(refers_to("drawer.handle", "drawer-2.handle-0", ""));
  CHECK(refers_to("seat", "a.b", "seat"));
  CHECK(refers_to("chair.seat", "chair.pad", "seat"));
  CHECK_FALSE(refers_to("leg", "legs", ""));
  CHECK_FALSE(refers_to("leg-3", "leg-4", ""));
  CHECK_FALSE(refers_to("handle", "drawer.handle", ""));
  CHECK_FALSE(refers_to("", "a", ""));
}
