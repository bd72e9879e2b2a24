#include "kind_json.h"

#include <algorithm>

namespace roomgen {

namespace {

// What hangs on a wall hangs with its middle at the height of the eyes, if nothing else is known.
constexpr double eye_height = 1.5;
constexpr double least_elevation = 0.1;

Side read_side(const JsonReader& json) {
  const std::string text = json.text();
  if (text == "back") return Side::back;
  if (text == "left") return Side::left;
  if (text == "right") return Side::right;
  if (text != "front") json.report("\"" + text + "\" is none of front, back, left, right");
  return Side::front;
}

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(500)) texts.push_back(element.text());
  return texts;
}

Mount read_mount(const JsonReader& json) {
  const auto mount = parse_mount(json.text());
  if (!mount) json.report("is none of floor, wall, ceiling, surface");
  return mount.value_or(Mount::floor);
}

void read_traits(const JsonReader& json, Traits& traits) {
  if (!json.exists()) return;
  traits = {false, false, false};
  for (const auto& element : json.elements(10)) {
    const std::string text = element.text();
    if (text == "front") traits.front = true;
    else if (text == "flat") traits.flat = true;
    else if (text == "round") traits.round = true;
    else element.report("\"" + text + "\" is none of front, flat, round");
  }
}

// What stands on a table needs no floor before it, whatever its bigger kin need.
void put_up(const JsonReader& json, Kind& kind) {
  if (!json.exists()) return;
  const Mount mount = read_mount(json);
  if (mount != kind.mount && mount != Mount::floor) {
    kind.zones.clear();
    kind.gaps.clear();
    kind.tucks_under.clear();
  }
  kind.mount = mount;
}

void read_elevation(const JsonReader& json, Kind& kind) {
  kind.elevation = json.number_or(kind.elevation, 0, 20);
  if (kind.mount == Mount::wall && kind.elevation <= 0.0)
    kind.elevation = std::max(least_elevation, eye_height - 0.5 * kind.size.z());
}

void read_use(const JsonReader& json, Kind& kind) {
  if (const auto zones = json["zones"]; zones.exists()) {
    kind.zones.clear();
    for (const auto& element : zones.elements(8)) {
      element.allow_only({"side", "depth", "partners", "inset", "lengthwise"});
      kind.zones.push_back({read_side(element["side"]), element["depth"].number(0.01, 5.0),
                            read_texts(element["partners"]),
                            element["inset"].number_or(0.0, 0.0, 5.0),
                            element["lengthwise"].boolean_or(false)});
    }
  }
  if (const auto gaps = json["gaps"]; gaps.exists()) {
    kind.gaps.clear();
    for (const auto& [partner, range] : gaps.members()) {
      const auto v = range.numbers(2, 0.0, 20.0);
      kind.gaps.push_back({partner, v[0], v[1]});
    }
  }
  if (json["tucks_under"].exists()) kind.tucks_under = read_texts(json["tucks_under"]);
}

void read_lamp(const JsonReader& json, Kind& kind) {
  if (!json.exists()) return;
  json.allow_only({"candela", "height", "cone"});
  kind.lamp = Lamp{json["candela"].number(0.01, 10000.0), json["height"].number_or(0.8, 0.0, 1.0),
                   json["cone"].number_or(0.0, 0.0, 90.0)};
}

void read_forms(const JsonReader& json, Forms& forms) {
  if (!json.exists()) return;
  json.allow_only({"small", "wall", "ceiling", "round"});
  forms = {json["small"].text_or(""), json["wall"].text_or(""), json["ceiling"].text_or(""),
           json["round"].text_or("")};
}

// As what other parts of roomgen know it.
void read_terms(const JsonReader& json, Kind& kind) {
  kind.variant = json["variant"].boolean_or(false);
  kind.stocked_as = json["stocked_as"].text_or(kind.variant ? kind.parent : kind.name);
  kind.built_as = json["built_as"].text_or(kind.name);
  kind.serves = json["serves"].text_or(kind.parent);
  kind.usual = json["usual"].boolean_or(false);
  if (json["substitutes"].exists())
    for (const auto& [other, fit] : json["substitutes"].members())
      kind.substitutes[other] = fit.number(0.01, 0.99);
}

}  // namespace

Kind child_of(const Kind& parent) {
  Kind kind = parent;
  kind.parent = parent.name;
  kind.names.clear();
  kind.loose_names.clear();
  kind.resembles.clear();
  kind.also.clear();
  kind.forms = {};
  kind.supports = false;
  kind.substitutes.clear();
  kind.stands_for.clear();
  return kind;
}

void read_kind(const JsonReader& json, Kind& kind) {
  json.allow_only({"is",       "names",         "loose_names", "resembles",  "size",
                   "mount",    "also",          "elevation",   "traits",     "faces",
                   "supports", "covers_window", "zones",       "gaps",       "tucks_under",
                   "foot",
                   "lamp",     "forms",         "variant",     "stocked_as", "built_as",
                   "serves",   "usual",         "substitutes", "hyponyms",   "stands_for",
                   "source"});
  kind.names = read_texts(json["names"]);
  kind.loose_names = read_texts(json["loose_names"]);
  kind.resembles = read_texts(json["resembles"]);
  if (const auto size = json["size"]; size.exists()) {
    const auto v = size.numbers(3, 0.001, 20.0);
    kind.size = {v[0], v[1], v[2]};
  }
  put_up(json["mount"], kind);
  read_elevation(json["elevation"], kind);
  for (const auto& element : json["also"].elements_or_none(4)) kind.also.push_back(read_mount(element));
  read_traits(json["traits"], kind.traits);
  if (json["faces"].exists()) kind.faces = read_side(json["faces"]);
  kind.supports = json["supports"].boolean_or(false);
  kind.covers_window = json["covers_window"].boolean_or(kind.covers_window);
  kind.foot = json["foot"].number_or(kind.foot, 0, 5);
  read_use(json, kind);
  read_lamp(json["lamp"], kind);
  read_forms(json["forms"], kind.forms);
  read_terms(json, kind);
  kind.hyponyms = static_cast<int>(json["hyponyms"].integer_or(2, 0, 16));
  kind.stands_for = read_texts(json["stands_for"]);
}

}  // namespace roomgen
