#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "description_words.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

namespace {

constexpr double centimetres = 100.0;  // in a metre

// Writing. Only what was said: a description is read by people, too.

Json size_json(const Vec3& size) {
  Json json = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    json.push_back(std::isnan(size[axis]) ? Json() : Json(rounded(size[axis] * centimetres)));
  return json;
}

void put(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

void put(Json& json, const std::optional<Vec3>& size, const Vec3& scale) {
  if (size) json["size_cm"] = size_json(*size);
  if (scale != Vec3::Ones())
    json["scale"] = {rounded(scale.x()), rounded(scale.y()), rounded(scale.z())};
}

Json part_json(const PartWish& part) {
  Json json = {{"label", part.label}};
  if (part.count) json["count"] = *part.count;
  put(json, "shape", part.shape);
  put(json, "construction", part.construction);
  put(json, "material", part.material);
  put(json, "color", part.color);
  if (part.lean) json["lean"] = rounded(*part.lean);
  if (part.course) json["course"] = name(*part.course);
  if (part.strength != Strength::moderate) json["strength"] = name(part.strength);
  put(json, "direction", part.direction);
  put(json, part.size, part.scale);
  if (!part.touches.empty()) json["touches"] = part.touches;
  return json;
}

// Reading.

std::optional<Vec3> read_size(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  const auto sides = json.elements(3);
  if (sides.size() != 3) {
    if (json.is_array()) json.report("expected width, depth and height; null for what is not said");
    return std::nullopt;
  }
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& side = sides[static_cast<std::size_t>(axis)];
    size[axis] =
        side.raw()->is_null()
            ? std::nan("")
            : side.number(least_size * centimetres, greatest_size * centimetres) / centimetres;
  }
  return size;
}

Vec3 read_scale(const JsonReader& json) {
  if (!json.exists()) return Vec3::Ones();
  const auto factors = json.numbers(3, least_scale, greatest_scale);
  return factors.size() == 3 ? Vec3(factors[0], factors[1], factors[2]) : Vec3(Vec3::Ones());
}

template <typename Named>
auto read_word(const JsonReader& json, Named named, const std::vector<std::string>& known)
    -> decltype(named("")) {
  if (!json.exists()) return std::nullopt;
  const std::string text = json.text(max_word);
  auto value = named(text);
  if (!value) json.report("\"" + text + "\" is not known; known are " + join(known, ", "));
  return value;
}

int read_count(const JsonReader& json, int fallback) {
  return static_cast<int>(json.integer_or(fallback, 0, max_count));
}

PartWish read_part(const JsonReader& json) {
  json.allow_only({"label", "count", "shape", "construction", "material", "color", "lean", "course",
                   "strength", "direction", "size_cm", "scale", "touches"});
  PartWish part;
  part.label = json["label"].text(max_word);
  if (part.label.empty() && json["label"].is_string()) json["label"].report("empty");
  if (json["count"].exists()) part.count = read_count(json["count"], 1);
  part.shape = json["shape"].text_or("", max_word);
  part.construction = json["construction"].text_or("", max_word);
  part.material = json["material"].text_or("", max_word);
  part.color = json["color"].text_or("", max_word);
  if (json["lean"].exists()) part.lean = json["lean"].number(-greatest_lean, greatest_lean);
  part.course = read_word(json["course"], course_named, course_names());
  part.strength =
      read_word(json["strength"], strength_named, strength_names()).value_or(Strength::moderate);
  part.direction = json["direction"].text_or("", max_word);
  part.size = read_size(json["size_cm"]);
  part.scale = read_scale(json["scale"]);
  for (const auto& other : json["touches"].elements_or_none(max_touches))
    part.touches.push_back(other.text(max_word));
  return part;
}

}  // namespace

Json to_json(const Description& description) {
  Json json = {{"object", description.noun}};
  put(json, "prompt", description.prompt);
  put(json, "kind", description.kind);
  if (description.approximate) json["approximate"] = true;
  json["count"] = description.count;
  put(json, "style", description.style);
  put(json, "material", description.material);
  put(json, "color", description.color);
  put(json, description.size, description.scale);
  json["parts"] = Json::array();
  for (const auto& part : description.parts) json["parts"].push_back(part_json(part));
  return json;
}

Result<Description> description_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  root.allow_only({"object", "prompt", "kind", "approximate", "count", "style", "material", "color",
                   "size_cm", "scale", "parts"});
  if (problems.first()) return *problems.first();
  Description description;
  description.noun = root["object"].text(max_word);
  description.prompt = root["prompt"].text_or("", max_prompt);
  description.kind = root["kind"].text_or("", max_word);
  description.approximate = root["approximate"].boolean_or(false);
  description.count = read_count(root["count"], 1);
  description.style = root["style"].text_or("", max_word);
  description.material = root["material"].text_or("", max_word);
  description.color = root["color"].text_or("", max_word);
  description.size = read_size(root["size_cm"]);
  description.scale = read_scale(root["scale"]);
  for (const auto& part : root["parts"].elements_or_none(max_parts))
    description.parts.push_back(read_part(part));
  if (problems.first()) return *problems.first();
  return description;
}

}  // namespace roomgen::create
