#include "part_forms.h"

#include "base/json_reader.h"
#include "base/resource.h"
#include "description_words.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr const char* parts_path = "data/create/parts.json";
constexpr const char* unknown_form = "block";

// A form is written as its components; the box that it fills are its parameters.
Json recipe_of(const std::string& name, const JsonReader& components) {
  const Json side = {{"value", 0.1}, {"min", 0.001}, {"max", 10}};
  return {{"format", "roomgen-shape"},
          {"version", 1},
          {"name", name},
          {"parameters", {{"width", side}, {"depth", side}, {"height", side}}},
          {"components", components.raw() ? *components.raw() : Json::array()}};
}

PartForm read_part(const JsonReader& json, const WordMap<Json>& forms) {
  json.allow_only({"names", "form", "place", "size", "same", "count", "spread", "material"});
  PartForm part;
  part.form = json["form"].text();
  if (!forms.count(part.form)) json["form"].report("is no form");
  const auto place = place_named(json["place"].text());
  if (!place) json["place"].report("is no place");
  part.place = place.value_or(Place::top);
  const auto size = json["size"].numbers(3, 0.005, 2);
  if (size.size() == 3) part.size = Vec3(size[0], size[1], size[2]);
  part.same = json["same"].text_or("");
  part.count = static_cast<int>(json["count"].number_or(1, 1, 24));
  part.spread = json["spread"].boolean_or(false);
  part.material = json["material"].text_or("");
  return part;
}

// A word that is a label itself means that one first.
void add_name(PartForms& parts, const std::string& word, const std::string& label) {
  auto& labels = parts.labels[word];
  if (singular(word) == label) labels.insert(labels.begin(), label);
  else labels.push_back(label);
}

Result<PartForms> read() {
  const auto json = parse_json(resource(parts_path).value_or(""), parts_path);
  if (!json) return json.error();
  JsonReader::Problems problems{parts_path};
  const JsonReader root(*json, problems);
  root.allow_only({"about", "shapes", "forms", "parts"});
  PartForms parts;
  for (const auto& [name, components] : root["forms"].members())
    parts.forms[name] = recipe_of(name, components);
  for (const auto& [word, form] : root["shapes"].members()) parts.shapes[word] = form.text();
  for (const auto& [label, part] : root["parts"].members()) {
    parts.parts[label] = read_part(part, parts.forms);
    for (const auto& name : part["names"].elements()) add_name(parts, name.text(), label);
  }
  if (const auto& problem = problems.first()) return *problem;
  return parts;
}

}  // namespace

PartForm PartForms::of(std::string_view label, int count) const {
  if (const auto found = parts.find(label); found != parts.end()) return found->second;
  PartForm part;
  part.form = unknown_form;
  part.known = false;
  part.place = count == 1 ? Place::top : count == 2 ? Place::side : Place::front;
  return part;
}

const Result<PartForms>& built_in_parts() {
  static const Result<PartForms> parts = read();
  return parts;
}

}  // namespace roomgen::create
