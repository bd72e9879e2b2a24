#include "plan_form.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json_values.h"
#include "composition/composition.h"
#include "plan/gathering.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

using composition::Composition;
using composition::Part;

/// Bytes of the compositions that are shown with their parts, and of the names of others.
constexpr std::size_t most_of_shown = 2200, most_of_names = 800;

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

// A mentioned thing says most of whose anchor it is, less of what it is a part of.
constexpr double of_anchor = 2.0, of_part = 1.0, of_very_kind = 1.0, told_by_things = 2.0;
constexpr double elsewhere = 0.5;  ///< of what such rooms do not have

double told_of(const Composition& composition, const brief::Brief& brief) {
  const KindTable& table = KindTable::built_in();
  double told = 0.0;
  for (const auto& mention : brief.mentions) {
    const Kind* asked = table.find(mention.category);
    const auto is_it = [&](const Part& part) {
      const Kind* kind = asked && part.spare == 0 ? table.by_name(part.kind) : nullptr;
      return kind && (is_of(*kind, asked->name) || is_of(*asked, kind->name));
    };
    const auto& parts = composition.parts;
    const auto found = std::find_if(parts.begin(), parts.end(), is_it);
    if (found == parts.end()) continue;
    told += found == parts.begin() ? of_anchor : of_part;
    if (found->kind == asked->name) told += of_very_kind;
  }
  return told;
}

// By what the wish asks for, and how readily rules take it. Of rooms that nobody knows only its
// things tell.
double suitability(const Composition& composition, const std::string& room, const std::string& wish,
                   const brief::Brief& brief) {
  const double ready = plan::readiness(composition, room, wish), told = told_of(composition, brief);
  if (ready == 0.0) return elsewhere * told;
  return told + (brief.type_known || told > 0.0 || ready > of_anchor ? ready : 0.0);
}

}  // namespace

const Json& plan_schema(bool whole) {
  static const Json inventory = inventory_schema();
  static const Json all = whole_schema();
  return whole ? all : inventory;
}

std::string composition_lines(const std::string& room, const brief::Brief& brief,
                              const std::string& wish) {
  const auto& known = composition::built_in_compositions();
  if (!known) return "";
  std::vector<std::pair<double, const Composition*>> ranked;
  for (const auto& [name, one] : *known)
    ranked.push_back({suitability(one, room, wish, brief), &one});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string lines, names;
  std::set<const Composition*> shown;
  // What they are made of is known too.
  const auto show = [&](const Composition& one, const auto& inner) -> void {
    if (!shown.insert(&one).second) return;
    lines += line_of(one) + "\n";
    for (const auto& part : one.parts)
      if (const auto of = known->find(part.composition); of != known->end())
        inner(of->second, inner);
  };
  for (const auto& [suits, one] : ranked)
    if (suits >= told_by_things && lines.size() + line_of(*one).size() < most_of_shown)
      show(*one, show);
  for (const auto& [suits, one] : ranked)
    if (!shown.count(one) && suits > 0.0 && names.size() + one->name.size() < most_of_names)
      names += (names.empty() ? "" : "; ") + one->name;
  return lines + (names.empty() ? "" : "Others, by name: " + names + "\n");
}

std::string kind_names(const KindTable& kinds) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds.all()) names.push_back(name);
  return join(names, ", ");
}

}  // namespace roomgen::design
