#include "reply_schema.h"

#include "description_words.h"

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

}  // namespace

const Json& verdict_schema() {
  static const Json schema = Json::parse(R"({"type": "object", "additionalProperties": false,
    "properties": {"passes": {"type": "boolean"}, "reason": {"type": "string"}},
    "required": ["passes", "reason"]})");
  return schema;
}

const Json& decompose_schema() {
  static const Json schema = with_words(
      Json::parse(R"({"type": "object", "additionalProperties": false, "required": ["objects"],
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
    Json result = Json::parse(R"({"type": "object", "additionalProperties": false,
      "required": ["format", "version", "name", "materials", "components", "connections"],
      "properties": {"format": {"const": "roomgen-shape"}, "version": {"const": 1},
        "name": {"type": "string"},
        "let": {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2,
          "items": {"type": ["string", "number"]}}},
        "materials": {"type": "object", "additionalProperties": {
          "type": "object", "required": ["color"], "additionalProperties": false,
          "properties": {"color": {"type": "string"}, "roughness": {"type": "number"},
            "metalness": {"type": "number"}, "opacity": {"type": "number"},
            "pattern": {"type": "string"}}}},
        "components": {"type": "array", "items": {"$ref": "#/$defs/component"}},
        "connections": {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2,
          "items": {"type": "string"}}}},
      "$defs": {
        "vec3": {"type": "array", "minItems": 3, "maxItems": 3,
          "items": {"type": ["number", "string"]}},
        "component": {"type": "object", "required": ["name", "label"],
          "additionalProperties": false,
          "properties": {"name": {"type": "string"}, "label": {"type": "string"},
            "when": {"type": ["number", "string"]},
            "group": {"type": "object", "required": ["components"], "additionalProperties": false,
              "properties": {"components": {"type": "array",
                "items": {"$ref": "#/$defs/component"}}}},
            "scale": {"$ref": "#/$defs/vec3"}, "rotate": {"$ref": "#/$defs/vec3"},
            "at": {"$ref": "#/$defs/vec3"},
            "operations": {"type": "array", "items": {"type": "object"}},
            "material": {"type": "string"}}}}})");
    auto& properties = result["$defs"]["component"]["properties"];
    for (const char* solid :
         {"box", "cylinder", "frustum", "ellipsoid", "prism", "plane", "lathe", "sweep", "extrude",
          "loft", "height_field", "leaf", "cushion", "picture"})
      properties[solid] = {{"type", "object"}};
    return result;
  }();
  return schema;
}

const Json& mesh_schema() {
  static const Json schema = Json::parse(R"({"type": "object", "additionalProperties": false,
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
    const Json score = Json::parse(R"({"type": "object", "additionalProperties": false,
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
