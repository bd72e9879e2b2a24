#include "arrangement.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "base/json_reader.h"
#include "base/resource.h"
#include "composition/composition.h"
#include "roomgen/base/json.h"

namespace roomgen {

namespace {

constexpr int max_ancestors = 8;

constexpr std::array<std::pair<std::string_view, Preference>, 23> preference_names = {{
    {"door", Preference::door},
    {"door line", Preference::door_line},
    {"door ahead", Preference::door_ahead},
    {"window", Preference::window},
    {"window behind", Preference::window_behind},
    {"window ahead", Preference::window_ahead},
    {"window wall", Preference::window_wall},
    {"wall middle", Preference::wall_middle},
    {"side wall", Preference::side_wall},
    {"corner", Preference::corner},
    {"wall near", Preference::wall_near},
    {"run", Preference::run},
    {"bare wall", Preference::bare_wall},
    {"center", Preference::center},
    {"aside", Preference::aside},
    {"apart", Preference::apart},
    {"view", Preference::view},
    {"square", Preference::square},
    {"angle", Preference::angle},
    {"long axis", Preference::long_axis},
    {"flank", Preference::flank},
    {"screen free", Preference::screen_free},
    {"rows", Preference::rows},
}};

constexpr std::array<std::string_view, 4> sides = {"front", "back", "left", "right"};

std::optional<Preference> find_preference(std::string_view text) {
  for (const auto& [word, preference] : preference_names)
    if (word == text) return preference;
  return std::nullopt;
}

void read_preferences(const JsonReader& json, Arrangement& arrangement) {
  if (!json.exists()) return;
  for (const auto& [word, weight] : json.members()) {
    if (const auto preference = find_preference(word))
      arrangement.preferences.push_back({*preference, weight.number(-5, 5)});
    else
      json.report("\"" + word + "\" is nothing that a thing can prefer");
  }
}

void read_reserve(const JsonReader& json, Arrangement& arrangement) {
  if (!json.exists()) return;
  json.allow_only({"front", "back", "left", "right"});
  for (std::size_t i = 0; i < sides.size(); ++i)
    arrangement.reserve[i] = json[sides[i]].number_or(0.0, 0, 5);
}

/// By name the constraints of a group, with * for the thing that it gathers at.
using Groups = std::map<std::string, std::string, std::less<>>;

// "beside: bed" is the group "beside" with a bed in the place of each *.
std::string spelled_out(const JsonReader& json, const Groups& groups) {
  const std::string way = json.text();
  const auto colon = way.find(": ");
  if (colon == std::string::npos) return way;
  const auto group = groups.find(way.substr(0, colon));
  if (group == groups.end()) {
    json.report("\"" + way.substr(0, colon) + "\" is no group");
    return "";
  }
  std::string text;
  for (char c : group->second) text += c == '*' ? way.substr(colon + 2) : std::string(1, c);
  return text;
}

std::vector<std::vector<Relation>> read_ways(const JsonReader& json, const Groups& groups) {
  std::vector<std::vector<Relation>> ways;
  for (const auto& way : json.elements_or_none(20)) {
    auto relations = parse_relations(spelled_out(way, groups));
    if (relations)
      ways.push_back(*std::move(relations));
    else
      way.report(relations.error().message);
  }
  return ways;
}

Arrangement read_arrangement(const JsonReader& json, const Groups& groups) {
  json.allow_only({"stage", "ways", "preferences", "reserve", "seats", "over", "else", "rows from"});
  Arrangement arrangement;
  arrangement.stage = static_cast<int>(json["stage"].integer_or(4, 0, 20));
  arrangement.ways = read_ways(json["ways"], groups);
  arrangement.otherwise = read_ways(json["else"], groups);
  read_preferences(json["preferences"], arrangement);
  read_reserve(json["reserve"], arrangement);
  arrangement.seats = json["seats"].boolean_or(false);
  arrangement.rows_from = static_cast<int>(json["rows from"].integer_or(0, 2, 300));
  if (const auto over = json["over"]; over.exists())
    for (const auto& [kind, shift] : over.members()) arrangement.over[kind] = shift.number(-2, 2);
  return arrangement;
}

std::string_view fallback_of(Mount mount) {
  switch (mount) {
    case Mount::wall:
      return "wall thing";
    case Mount::ceiling:
      return "ceiling thing";
    case Mount::surface:
      return "surface thing";
    case Mount::floor:
      break;
  }
  return "room thing";
}

}  // namespace

const Arrangement& Arrangements::get(const KindTable& table, std::string_view category,
                                     Mount mount) const {
  static const Arrangement none;
  const Kind* kind = table.find(category);
  // A thing that is mounted in an unusual way (a television on the wall) goes with those.
  const bool usual = kind && kind->mount == mount;
  for (int i = 0; usual && kind && i < max_ancestors; ++i) {
    if (const auto found = kinds.find(kind->name); found != kinds.end()) return found->second;
    kind = kind->parent.empty() ? nullptr : table.find(kind->parent);
  }
  const auto found = kinds.find(fallback_of(mount));
  return found == kinds.end() ? none : found->second;
}

namespace {

Status add_wants(const composition::Composition& one, const Groups& groups, Arrangements& arrangements) {
  const std::string source = "composition \"" + one.name + "\", wants";
  const auto json = parse_json(one.wants, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  arrangements.compositions[one.name] = read_arrangement(JsonReader(*json, problems), groups);
  if (problems.first()) return *problems.first();
  return {};
}

}  // namespace

Result<Arrangements> parse_arrangements(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "groups", "kinds"});
  Groups groups;
  if (const auto named = root["groups"]; named.exists())
    for (const auto& [name, way] : named.members()) groups[name] = way.text();
  Arrangements arrangements;
  for (const auto& [kind, entry] : root["kinds"].members())
    arrangements.kinds[kind] = read_arrangement(entry, groups);
  if (problems.first()) return *problems.first();
  const auto& compositions = composition::built_in_compositions();
  if (!compositions) return compositions.error();
  for (const auto& [name, one] : *compositions)
    if (!one.wants.empty())
      if (auto status = add_wants(one, groups, arrangements); !status) return status.error();
  return arrangements;
}

const Result<Arrangements>& built_in_arrangements() {
  static const auto arrangements = parse_arrangements(
      resource("data/arrangements.json").value_or("{}"), "data/arrangements.json");
  return arrangements;
}

}  // namespace roomgen
