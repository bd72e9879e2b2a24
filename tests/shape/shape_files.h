#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "catch.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

/// What the tests of shape programs share.
inline const std::string shapes_folder = ROOMGEN_TEST_DATA "/shapes";
inline const std::vector<std::string> shape_names = {
    "bar-stool", "bookshelf", "chair", "floor-lamp", "leg", "sofa", "vase"};

inline roomgen::Json shape_file(const std::string& name) {
  auto json = roomgen::shape::read_recipe(shapes_folder + "/" + name + ".json");
  REQUIRE(json);
  return *json;
}

inline roomgen::Json parsed(const std::string& text) {
  auto json = roomgen::parse_json(text, "test");
  INFO(text);
  REQUIRE(json);
  return *json;
}

/// A document with this list of components and the material "m".
inline roomgen::Json document(const std::string& components, const std::string& rest = "") {
  return parsed(
      R"({"format": "roomgen-shape", "version": 1, "materials": {"m": {"color": "oak"}},)" + rest +
      R"("components": [)" + components + "]}");
}

inline roomgen::shape::Program concrete(const roomgen::Json& recipe,
                                        const roomgen::shape::Values& values = {},
                                        std::uint64_t seed = 0) {
  auto program = roomgen::shape::instantiate(recipe, values, seed,
                                             roomgen::shape::recipes_in(shapes_folder), "test");
  INFO((program ? "" : program.error().message));
  REQUIRE(program);
  return *program;
}

inline std::string refusal(const roomgen::Json& recipe, const roomgen::shape::Values& values = {},
                           const roomgen::shape::RecipeSource& lookup = nullptr) {
  const auto program = roomgen::shape::instantiate(recipe, values, 0, lookup, "test");
  INFO(recipe.dump().substr(0, 2000));
  REQUIRE_FALSE(program);
  return program.error().message;
}

inline roomgen::shape::Shape made(const roomgen::shape::Program& program) {
  auto shape = roomgen::shape::evaluate(program);
  INFO((shape ? "" : shape.error().message));
  REQUIRE(shape);
  return *shape;
}
