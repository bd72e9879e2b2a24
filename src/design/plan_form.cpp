#include "plan_form.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "composition/composition.h"
#include "plan/gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

using composition::Composition;
using composition::Part;

constexpr std::size_t most_shown = 45;  ///< compositions with their parts

/// Endpoints enforce a schema where every member of an object is required: what may be left out may
/// be null.
Json object_of(const Json& properties) {
  Json form = {{"type", "object"}, {"additionalProperties", false}, {"properties", properties}};
  form["required"] = Json::array();
  for (const auto& [key, value] : properties.items()) form["required"].push_back(key);
  return form;
}

Json list_of(const Json& element) { return {{"type", "array"}, {"items", element}}; }
Json or_null(const Json& form) { return {{"anyOf", {Json{{"type", "null"}}, form}}}; }

const Json& text() {
  static const Json form = {{"type", "string"}};
  return form;
}
const Json& number() {
  static const Json form = {{"type", "number"}};
  return form;
}

Json numbers(int count) {
  return {{"type", "array"}, {"items", number()}, {"minItems", count}, {"maxItems", count}};
}

Json thing_form() {
  return {{"name", text()}, {"description", text()}, {"size_cm", numbers(3)}, {"quantity", {{"type", "integer"}}},
          {"variance", {{"type", "string"}, {"enum", {"same", "varied"}}}}, {"place", text()}};
}

Json carrier_form() {
  Json form = thing_form();
  form["on_top"] = list_of(object_of(thing_form()));
  return form;
}

// Long lists are bounded when they are read: grammar samplers grow slow with such bounds.
Json inventory_schema() {
  const Json room = object_of({{"type", text()}, {"size_m", numbers(2)}, {"polygon_m", or_null(list_of(numbers(2)))},
                               {"height_m", number()}});
  return object_of({{"room", room}, {"objects", list_of(object_of(carrier_form()))}, {"excluded", list_of(text())}});
}

Json look_form() {
  const Json lower = object_of({{"finish", or_null(text())}, {"height", number()}});
  const Json cover = object_of({{"wall", or_null(text())}, {"finish", or_null(text())}, {"lower", or_null(lower)}});
  Json form;
  form["materials"] = object_of({{"floor", text()}, {"walls", list_of(cover)}, {"ceiling", text()}});
  form["light"] = object_of({{"hour", or_null(number())}, {"sky", or_null(text())}, {"level", or_null(text())},
                             {"warmth", or_null(text())}, {"lamps", or_null(list_of(text()))}});
  form["style"] = list_of(text());
  form["palette"] = object_of({{"main", or_null(text())}, {"second", or_null(text())}, {"accent", or_null(text())},
                               {"wood", or_null(text())}, {"metal", or_null(text())}});
  return form;
}

Json group_form() {
  Json thing = {{"part", text()}, {"name", text()}, {"description", text()}, {"size_cm", or_null(numbers(3))},
                {"quantity", or_null(number())}, {"variance", {{"type", "string"}, {"enum", {"same", "varied"}}}},
                {"where", or_null(text())}, {"gap_m", or_null(number())}, {"at_m", or_null(numbers(2))},
                {"facing", or_null(text())}};
  const Json setting = object_of({{"name", text()}, {"value", {{"anyOf", {number(), text()}}}}});
  const Json repeat = object_of({{"rows", number()}, {"columns", number()}, {"across_m", or_null(number())},
                                 {"along_m", or_null(number())}});
  return object_of({{"id", text()}, {"composition", or_null(text())}, {"with", list_of(setting)},
                    {"without", list_of(text())}, {"repeat", or_null(repeat)}, {"things", list_of(object_of(thing))}});
}

Json whole_schema() {
  Json room = look_form();
  room["type"] = text();
  room["size_m"] = numbers(2);
  room["polygon_m"] = or_null(list_of(numbers(2)));
  room["height_m"] = number();
  Json object = carrier_form();
  object["bottom_m"] = or_null(number());
  object["lean_deg"] = or_null(number());
  const Json opening = object_of({{"kind", text()}, {"wall", text()}, {"at", or_null(number())}, {"width", or_null(number())},
                                  {"sill", or_null(number())}, {"head", or_null(number())}, {"for", or_null(text())}});
  return object_of({{"concept", text()}, {"room", object_of(room)}, {"openings", list_of(opening)},
                    {"groups", list_of(group_form())}, {"objects", list_of(object_of(object))},
                    {"excluded", list_of(text())}});
}

std::string where(const Part& part) {
  const std::string of = part.of.empty() ? "" : " " + part.of;
  if (part.where == composition::Where::around) return " around" + of;
  if (part.where == composition::Where::beside) return " beside" + of;
  return part.on ? " on" + of : "";
}

std::string line_of(const Composition& composition) {
  std::vector<std::string> settings, parts;
  for (const auto& parameter : composition.parameters) {
    const double* value = std::get_if<double>(&parameter.value);
    settings.push_back(parameter.name + " " +
                       (value ? format_number(parameter.least, 2) + " to " + format_number(parameter.most, 2)
                              : join(parameter.choices, " or ")));
  }
  for (const auto& part : composition.parts)
    parts.push_back(part.name + (part.spare > 0 ? "*" : "") + " = " +
                    (part.kind.empty() ? "group " + part.composition : part.kind) + where(part));
  return composition.name + (settings.empty() ? "" : " [" + join(settings, ", ") + "]") + ": " + join(parts, "; ");
}

}  // namespace

const Json& plan_schema(bool whole) {
  static const Json inventory = inventory_schema();
  static const Json all = whole_schema();
  return whole ? all : inventory;
}

std::string composition_lines(const std::string& room, const std::string& wish) {
  const auto& known = composition::built_in_compositions();
  if (!known) return "";
  std::vector<std::pair<double, const Composition*>> by_readiness;
  for (const auto& [name, one] : *known) by_readiness.push_back({plan::readiness(one, room, wish), &one});
  std::stable_sort(by_readiness.begin(), by_readiness.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Composition*> shown;
  const auto show = [&](const Composition& one) {
    if (std::find(shown.begin(), shown.end(), &one) == shown.end()) shown.push_back(&one);
  };
  for (std::size_t i = 0; i < by_readiness.size() && i < most_shown; ++i)
    if (by_readiness[i].first > 0.0) show(*by_readiness[i].second);
  // What they are made of is known too.
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (const auto& part : shown[i]->parts)
      if (const auto inner = known->find(part.composition); inner != known->end()) show(inner->second);
  std::string lines;
  for (const auto* one : shown) lines += line_of(*one) + "\n";
  std::vector<std::string> others;
  for (const auto& [name, one] : *known)
    if (std::find(shown.begin(), shown.end(), &one) == shown.end()) others.push_back(name);
  return lines + "Others, by name: " + join(others, "; ") + "\n";
}

std::string kind_names(const KindTable& kinds) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds.all()) names.push_back(name);
  return join(names, ", ");
}

}  // namespace roomgen::design
