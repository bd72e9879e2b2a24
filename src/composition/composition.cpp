#include "composition.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/text.h"

namespace roomgen::composition {

namespace {

constexpr std::array<std::string_view, 4> side_names = {"front", "back", "left", "right"};
constexpr std::array<std::string_view, 4> facing_names = {"same", "opposite", "to", "away"};

/// Reads formulas; a bare number is one.
std::optional<Formula> formula(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  const std::string text = json.is_string() ? json.text(Formula::max_length)
                                            : format_number(json.number(-1000, 1000), 6);
  auto compiled = Formula::compile(text);
  if (compiled) return *std::move(compiled);
  json.report("\"" + text.substr(0, 60) + "\": " + compiled.error().message);
  return std::nullopt;
}

Formula constant(double value) {
  return *Formula::compile(format_number(value, 6));
}

Formula formula_or(const JsonReader& json, double fallback) {
  auto found = formula(json);
  return found ? *std::move(found) : constant(fallback);
}

void read_sides(const JsonReader& json, Part& part) {
  const std::string text = json.text_or("front");
  if (text == "sides")
    part.sides = {Side::left, Side::right};
  else if (text == "ends")
    part.sides = {Side::front, Side::back};
  else if (text == "all")
    part.sides = {Side::front, Side::back, Side::left, Side::right};
  else if (const auto found = std::find(side_names.begin(), side_names.end(), text);
           found != side_names.end())
    part.sides = {static_cast<Side>(found - side_names.begin())};
  else
    json.report("\"" + text + "\" is none of front, back, left, right, sides, ends, all");
}

// Exactly one of the words that say where.
void read_where(const JsonReader& json, Part& part) {
  struct Word {
    const char* text;
    Where where;
    std::optional<Mount> mount;
  };
  static const Word places[] = {{"beside", Where::beside, {}},       {"around", Where::around, {}},
                                {"under", Where::at, Mount::floor},  {"over", Where::at, Mount::ceiling},
                                {"above", Where::at, Mount::wall},   {"of", Where::at, {}},
                                {"on", Where::at, Mount::surface}};
  int words = 0;
  for (const auto& [text, where, mount] : places) {
    if (!json[text].exists()) continue;
    ++words;
    part.of = json[text].text(100);
    part.where = where;
    if (mount) part.mount = mount;
  }
  part.on = json["on"].exists();
  if (json["before"].exists()) part.where = Where::before, part.seat = json["before"].text(100);
  if (words > 1) json.report("says more than one of beside, around, under, over, above, of, on");
  if (part.where == Where::before && !part.on)
    json["before"].report("belongs to what stands \"on\" something");
  read_sides(json["side"], part);
  const std::string align = json["align"].text_or("middle");
  if (align == "back")
    part.align = Part::Align::back;
  else if (align == "front")
    part.align = Part::Align::front;
  else if (align != "middle")
    json["align"].report("\"" + align + "\" is none of middle, back, front");
}

void read_facing(const JsonReader& json, Part& part) {
  if (!json.exists()) return;
  const std::string text = json.text();
  const auto found = std::find(facing_names.begin(), facing_names.end(), text);
  if (found == facing_names.end())
    json.report("\"" + text + "\" is none of same, opposite, to, away");
  else
    part.facing = static_cast<Facing>(found - facing_names.begin());
}

std::optional<Repeat> read_repeat(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  json.allow_only(
      {"rows", "columns", "across", "along", "stagger", "number", "radius", "from", "to"});
  return Repeat{json["radius"].exists(),
                formula_or(json["rows"], 1),
                formula_or(json["columns"], 1),
                formula_or(json["across"], 1),
                formula_or(json["along"], 1),
                formula_or(json["stagger"], 0),
                formula_or(json["number"], most_members + 1),
                formula_or(json["radius"], 0),
                formula_or(json["from"], 0),
                formula_or(json["to"], 360)};
}

void read_size(const JsonReader& json, Part& part) {
  if (!json.exists()) return;
  const auto elements = json.elements(3);
  if (elements.size() != 3) return json.report("expected width, depth and height");
  for (std::size_t axis = 0; axis < 3; ++axis) part.size[axis] = formula(elements[axis]);
}

void read_place(const JsonReader& json, Part& part) {
  read_where(json, part);
  read_facing(json["facing"], part);
  part.first_only = json["first"].boolean_or(false);
  part.count = formula(json["count"]);
  part.gap = formula(json["gap"]);
  part.pitch = formula(json["pitch"]);
  part.shift = formula(json["shift"]);
  part.yaw = formula(json["yaw"]);
  part.height = formula(json["height"]);
  part.when = formula(json["when"]);
  if (const auto at = json["at"]; at.exists()) {
    const auto elements = at.elements(2);
    if (elements.size() != 2)
      at.report("expected x and y");
    else
      part.x = formula(elements[0]), part.y = formula(elements[1]);
  }
  part.repeat = read_repeat(json["repeat"]);
}

Part read_part(const JsonReader& json) {
  json.allow_only({"part",   "kind",     "group",  "with",   "description", "size",
                   "mount",  "variance", "beside", "around", "under",       "over",
                   "above",  "of",       "on",     "before", "side",        "align",
                   "facing", "first",    "count",  "gap",    "pitch",       "shift",
                   "at",     "yaw",      "height", "when",   "repeat",      "spare"});
  Part part;
  part.kind = lower(json["kind"].text_or("", 200));
  part.composition = json["group"].text_or("", 200);
  if (part.kind.empty() == part.composition.empty())
    json.report("a part is either a \"kind\" or a \"group\"");
  part.name = json["part"].text_or(part.kind.empty() ? part.composition : part.kind, 100);
  if (part.name.find('/') != std::string::npos) json["part"].report("a name holds no \"/\"");
  if (const auto with = json["with"]; with.exists())
    for (const auto& [name, value] : with.members())
      if (auto read = formula(value)) part.with.emplace(name, *std::move(read));
  part.description = json["description"].text_or("", 2000);
  read_size(json["size"], part);
  if (const auto mount = json["mount"]; mount.exists()) {
    part.mount = parse_mount(mount.text());
    if (!part.mount) mount.report("is none of floor, wall, ceiling, surface");
  }
  part.varied = json["variance"].text_or("same") == "varied";
  read_place(json, part);
  part.spare = static_cast<int>(json["spare"].integer_or(0, 0, 100));
  return part;
}

Parameter read_parameter(const std::string& name, const JsonReader& json) {
  Parameter parameter;
  parameter.name = name;
  json.allow_only({"default", "least", "most", "try", "shrinks", "choices"});
  for (const auto& choice : json["choices"].elements_or_none(20))
    parameter.choices.push_back(choice.text(100));
  if (!parameter.choices.empty()) {
    parameter.value = json["default"].text_or(parameter.choices.front());
  } else {
    const double value = json["default"].number(-1000, 1000);
    parameter.value = value;
    parameter.least = json["least"].number_or(value, -1000, 1000);
    parameter.most = json["most"].number_or(std::max(value, parameter.least), -1000, 1000);
    if (parameter.least > parameter.most) json.report("the least is above the most");
  }
  for (const auto& other : json["try"].elements_or_none(12))
    if (auto read = formula(other)) parameter.others.push_back(*std::move(read));
  parameter.shrinks = json["shrinks"].boolean_or(false);
  return parameter;
}

// What a part refers to must come before it, so that nothing goes round in a circle.
void check_references(const JsonReader& json, const std::vector<Part>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto is_known = [&](const std::string& name) {
      const std::string head = name.substr(0, name.find('/'));
      return std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(i),
                         [&](const Part& part) { return part.name == head; });
    };
    if (i > 0 && parts[i].of.empty())
      json.report("\"" + parts[i].name +
                  "\" does not say where it is: only the first part, the anchor, may");
    for (const auto& name : {parts[i].of, parts[i].seat})
      if (!name.empty() && !is_known(name))
        json.report("\"" + parts[i].name + "\" refers to \"" + name +
                    "\", which is no part before it");
    if (i == 0 && !parts[i].of.empty())
      json.report("the first part, the anchor, stands where it is");
    for (std::size_t j = 0; j < i; ++j)
      if (parts[j].name == parts[i].name)
        json.report("two parts are called \"" + parts[i].name + "\"");
  }
}

}  // namespace

Result<Composition> read_composition(const Json& json, const std::string& name,
                                     const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  root.allow_only({"for", "source", "parameters", "parts", "mirrors", "wants"});
  Composition composition;
  composition.name = name;
  composition.source = root["source"].text_or("", 2000);
  for (const auto& use : root["for"].elements_or_none(40))
    composition.uses.push_back(use.text(100));
  if (const auto parameters = root["parameters"]; parameters.exists())
    for (const auto& [key, value] : parameters.members())
      composition.parameters.push_back(read_parameter(key, value));
  for (const auto& part : root["parts"].elements(most_parts))
    composition.parts.push_back(read_part(part));
  if (composition.parts.empty()) root.report("a group needs an anchor, the first of its \"parts\"");
  check_references(root["parts"], composition.parts);
  composition.mirrors = root["mirrors"].boolean_or(false);
  if (const auto wants = root["wants"]; wants.exists()) composition.wants = json_line(*wants.raw());
  if (problems.first()) return *problems.first();
  return composition;
}

const Result<Compositions>& built_in_compositions() {
  static const Result<Compositions> all = []() -> Result<Compositions> {
    Compositions found;
    for (const auto path : resources("data/compositions/")) {
      const auto json = parse_json(*resource(path), std::string(path));
      if (!json) return json.error();
      for (const auto& [name, value] : json->items()) {
        auto one = read_composition(value, name, std::string(path) + ": " + name);
        if (!one) return one.error();
        one->family =
            std::string(path.substr(path.rfind('/') + 1, path.rfind('.') - path.rfind('/') - 1));
        if (!found.emplace(name, *std::move(one)).second)
          return Error{Error::Kind::invalid_input,
                       std::string(path) + ": there is another \"" + name + "\""};
      }
    }
    return found;
  }();
  return all;
}

}  // namespace roomgen::composition
