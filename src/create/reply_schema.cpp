#include "base/json_values.h"
#include "description_words.h"
#include "maker_questions.h"

namespace roomgen::create {

namespace {

// Lists are bounded when they are read: grammar samplers grow slow with such bounds.

Json with_words(Json schema) {
  auto& part = schema["properties"]["objects"]["items"]["properties"]["parts"]["items"];
  for (const auto& course : course_names()) part["properties"]["course"]["enum"].push_back(course);
  for (const auto& strength : strength_names())
    part["properties"]["strength"]["enum"].push_back(strength);
  return schema;
}

// The simple solids with their members, which weak models leave out or invent otherwise; the drawn
// ones are left to the reader.
const Json& solid_forms() {
  static const Json forms = [] {
    Json result = json_literal(R"({
      "box": {"required": ["size"], "properties": {"size": {"$ref": "#/$defs/vec3"},
        "bevel": {"$ref": "#/$defs/number"}}},
      "cylinder": {"required": ["radius", "height"], "properties": {
        "radius": {"$ref": "#/$defs/number"}, "height": {"$ref": "#/$defs/number"},
        "bevel": {"$ref": "#/$defs/number"}}},
      "frustum": {"required": ["bottom_radius", "top_radius", "height"], "properties": {
        "bottom_radius": {"$ref": "#/$defs/number"}, "top_radius": {"$ref": "#/$defs/number"},
        "height": {"$ref": "#/$defs/number"}, "bevel": {"$ref": "#/$defs/number"}}},
      "ellipsoid": {"required": ["size"], "properties": {"size": {"$ref": "#/$defs/vec3"}}},
      "prism": {"required": ["sides", "radius", "height"], "properties": {
        "sides": {"$ref": "#/$defs/number"}, "radius": {"$ref": "#/$defs/number"},
        "height": {"$ref": "#/$defs/number"}}},
      "cushion": {"required": ["size"], "properties": {"size": {"$ref": "#/$defs/vec3"},
        "softness": {"$ref": "#/$defs/number"}}},
      "group": {"required": ["components"], "properties": {"components": {"type": "array",
        "items": {"$ref": "#/$defs/component"}}}}})");
    for (auto& form : result) {
      form["type"] = "object";
      form["additionalProperties"] = false;
    }
    for (const char* drawn : {"plane", "lathe", "sweep", "extrude", "loft", "height_field", "leaf",
                              "picture", "text"})
      result[drawn] = {{"type", "object"}};
    return result;
  }();
  return forms;
}

// A component has exactly one solid.
Json component_of(const std::string& solid, const Json& form) {
  Json result = json_literal(R"({"type": "object", "additionalProperties": false,
    "required": ["name", "label"],
    "properties": {"name": {"type": "string"}, "label": {"type": "string"}}})");
  result["required"].push_back(solid);
  auto& properties = result["properties"];
  properties[solid] = form;
  properties["when"] = {{"$ref", "#/$defs/number"}};
  for (const char* vector : {"scale", "rotate", "at"}) properties[vector] = {{"$ref", "#/$defs/vec3"}};
  properties["operations"] = {{"type", "array"}, {"items", {{"type", "object"}}}};
  properties["material"] = {{"type", "string"}};
  return result;
}

}  // namespace

const Json& verdict_schema() {
  static const Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "properties": {"passes": {"type": "boolean"}, "reason": {"type": "string"}},
    "required": ["passes", "reason"]})");
  return schema;
}

const Json& decompose_schema() {
  static const Json schema = with_words(
      json_literal(R"({"type": "object", "additionalProperties": false, "required": ["objects"],
    "properties": {"objects": {"type": "array", "items": {
      "type": "object", "additionalProperties": false,
      "required": ["object", "words", "kind", "approximate", "count", "style", "material", "color",
                   "size_cm", "parts"],
      "properties": {"object": {"type": "string"}, "words": {"type": "string"},
        "kind": {"type": "string"}, "approximate": {"type": "boolean"},
        "count": {"type": "integer"}, "style": {"type": "string"}, "material": {"type": "string"},
        "color": {"type": "string"},
        "size_cm": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
        "parts": {"type": "array", "items": {
          "type": "object", "additionalProperties": false,
          "required": ["label", "count", "size_cm", "shape", "construction", "symmetry", "material",
                       "color", "lean", "course", "strength", "direction", "touches"],
          "properties": {"label": {"type": "string"}, "count": {"type": "integer"},
            "size_cm": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
            "shape": {"type": "string"}, "construction": {"type": "string"},
            "symmetry": {"type": "string", "enum": ["none", "mirror", "ring", "row"]},
            "material": {"type": "string"}, "color": {"type": "string"},
            "lean": {"type": "number"}, "course": {"type": "string", "enum": []},
            "strength": {"type": "string", "enum": []}, "direction": {"type": "string"},
            "touches": {"type": "array", "items": {"type": "string"}}}}}}}}}})"));
  return schema;
}

const Json& program_schema() {
  static const Json schema = [] {
    Json result = json_literal(R"({"type": "object", "additionalProperties": false,
      "required": ["format", "version", "name", "materials", "components", "connections"],
      "properties": {"format": {"const": "roomgen-shape"}, "version": {"const": 1},
        "name": {"type": "string"},
        "let": {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2,
          "items": {"type": ["string", "number"]}}},
        "materials": {"type": "object", "additionalProperties": {
          "type": "object", "required": ["color"], "additionalProperties": false,
          "properties": {"color": {"type": "string"}, "roughness": {"type": "number"},
            "metalness": {"type": "number"}, "opacity": {"type": "number"},
            "pattern": {"type": "string"}, "glow": {"type": "number"}}}},
        "components": {"type": "array", "items": {"$ref": "#/$defs/component"}},
        "connections": {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2,
          "items": {"type": "string"}}}},
      "$defs": {
        "number": {"type": ["number", "string"]},
        "vec3": {"type": "array", "minItems": 3, "maxItems": 3,
          "items": {"type": ["number", "string"]}}}})");
    for (const auto& [solid, form] : solid_forms().items())
      result["$defs"]["component"]["anyOf"].push_back(component_of(solid, form));
    return result;
  }();
  return schema;
}

const Json& mesh_schema() {
  static const Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "required": ["vertices", "triangles", "parts"],
    "properties": {
      "vertices": {"type": "array", "items": {"type": "array", "items": {"type": "number"},
        "minItems": 3, "maxItems": 3}},
      "triangles": {"type": "array", "items": {"type": "array", "items": {"type": "integer"},
        "minItems": 3, "maxItems": 3}},
      "parts": {"type": "array", "items": {"type": "object", "additionalProperties": false,
        "required": ["label", "first", "count", "color"],
        "properties": {"label": {"type": "string"}, "first": {"type": "integer"},
          "count": {"type": "integer"}, "color": {"type": "string"}}}}}})");
  return schema;
}

const Json& scores_schema() {
  static const Json schema = [] {
    const Json score = json_literal(R"({"type": "object", "additionalProperties": false,
      "required": ["reason", "points"],
      "properties": {"reason": {"type": "string"}, "points": {"type": "integer"}}})");
    Json result = {{"type", "object"}, {"additionalProperties", false}};
    for (const char* rubric : {"structure", "realism", "alignment"}) {
      result["properties"][rubric] = score;
      result["required"].push_back(rubric);
    }
    return result;
  }();
  return schema;
}

}  // namespace roomgen::create
