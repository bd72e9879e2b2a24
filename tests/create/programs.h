#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catch.h"
#include "create/validate.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/program.h"

/// Shape programs for the tests of the validator.
inline const std::vector<std::string> example_names = {"bar-stool",  "bookshelf", "chair",
                                                       "floor-lamp", "sofa",      "vase"};

inline roomgen::shape::Program example(const std::string& name,
                                       const roomgen::shape::Values& values = {},
                                       std::uint64_t seed = 0) {
  const std::string folder = ROOMGEN_TEST_DATA "/shapes";
  const auto json = roomgen::shape::read_recipe(folder + "/" + name + ".json");
  REQUIRE(json);
  auto program =
      roomgen::shape::instantiate(*json, values, seed, roomgen::shape::recipes_in(folder), name);
  INFO((program ? "" : program.error().message));
  REQUIRE(program);
  return *program;
}

/// With this list of components, and of connections.
inline roomgen::shape::Program program(const std::string& components,
                                       const std::string& connections = "") {
  const auto json =
      roomgen::parse_json(R"({"format": "roomgen-shape", "version": 1, "components": [)" +
                              components + R"(], "connections": [)" + connections + "]}",
                          "test");
  REQUIRE(json);
  auto made = roomgen::shape::instantiate(*json);
  INFO((made ? "" : made.error().message));
  REQUIRE(made);
  return *made;
}

/// A sound table: four swept legs that curve outwards, made by mirrors.
inline roomgen::shape::Program curved_table(bool connected = true) {
  return program(R"(
    {"name": "top", "label": "top", "box": {"size": [1.2, 0.7, 0.03], "bevel": 0.004}, "at": [0, 0, 0.7]},
    {"name": "leg", "label": "leg",
     "sweep": {"path": [[0.5, 0.28, 0.702], [0.44, 0.24, 0.4], [0.52, 0.3, 0]], "radius": 0.02, "taper": 0.6},
     "operations": [{"mirror": "x"}, {"mirror": "y"}, {"ground": true}]},
    {"name": "shelf", "label": "shelf", "box": {"size": [0.9, 0.5, 0.02]}, "at": [0, 0, 0.39]})",
                 connected ? R"(["leg", "top"], ["leg", "floor"], ["shelf", "leg"])" : "");
}

/// A sound pedestal table of lathes with a vase on it.
inline roomgen::shape::Program turned_table() {
  return program(R"(
    {"name": "foot", "label": "base", "lathe": {"profile": [[0, 0], [0.24, 0], [0.2, 0.03], [0.04, 0.06], [0, 0.06]], "corners": "all"}},
    {"name": "column", "label": "column", "lathe": {"profile": [[0, 0], [0.04, 0], [0.06, 0.2], [0.03, 0.5], [0.05, 0.65], [0, 0.65]], "corners": [0, 1, 4, 5]}, "at": [0, 0, 0.058]},
    {"name": "top", "label": "top", "cylinder": {"radius": 0.4, "height": 0.03, "bevel": 0.008}, "at": [0, 0, 0.706]},
    {"name": "vase", "label": "vase", "lathe": {"profile": [[0, 0], [0.05, 0], [0.07, 0.1], [0.03, 0.2], [0, 0.2]], "corners": [0, 1, 3, 4]}, "at": [0.1, 0.05, 0.735]})",
                 R"(["column", "foot"], ["top", "column"], ["foot", "floor"], ["vase", "top"])");
}

/// A sound dresser without any declared connection: body, feet, drawers with handles.
inline roomgen::shape::Program dresser() {
  return program(R"(
    {"name": "body", "label": "body", "box": {"size": [0.9, 0.45, 0.7]}, "at": [0, 0, 0.12]},
    {"name": "foot", "label": "leg", "frustum": {"bottom_radius": 0.015, "top_radius": 0.025, "height": 0.125},
     "at": [0.38, 0.17, 0], "operations": [{"mirror": "x"}, {"mirror": "y"}]},
    {"name": "drawer", "label": "drawer", "at": [0, -0.225, 0.15],
     "operations": [{"array": {"count": 3, "step": [0, 0, 0.22]}}],
     "group": {"components": [
       {"name": "front", "label": "drawer", "box": {"size": [0.84, 0.02, 0.2]}},
       {"name": "knob", "label": "handle", "ellipsoid": {"size": [0.03, 0.03, 0.03]}, "at": [0.2, -0.023, 0.09], "operations": [{"mirror": "x"}]}]}})");
}

/// A sound stool whose legs are held together by rungs.
inline roomgen::shape::Program runged_stool() {
  return program(R"(
    {"name": "seat", "label": "seat", "box": {"size": [0.4, 0.4, 0.03]}, "at": [0, 0, 0.45]},
    {"name": "leg", "label": "leg", "box": {"size": [0.03, 0.03, 0.45]}, "at": [0.17, 0.17, 0],
     "operations": [{"mirror": "x"}, {"mirror": "y"}]},
    {"name": "rung", "label": "rung", "cylinder": {"radius": 0.01, "height": 0.32}, "rotate": [0, 90, 0],
     "at": [-0.16, 0.17, 0.15], "operations": [{"mirror": "y"}]})",
                 R"(["leg", "seat"], ["leg", "floor"], ["rung", "leg"])");
}
