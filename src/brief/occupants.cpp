#include "occupants.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "scene/document_parts.h"

namespace roomgen::brief {

namespace {

constexpr const char* path = "data/occupants.json";
constexpr int most = 20;

Occupant::Thing read_thing(const JsonReader& json) {
  json.allow_only({"kind", "count", "each", "relation", "to", "needs"});
  Occupant::Thing thing;
  thing.kind = json["kind"].text(100);
  thing.count = static_cast<int>(json["count"].integer_or(0, 0, most));
  thing.each = json["each"].boolean_or(false);
  if (json["relation"].exists()) thing.relation = read_relation(json["relation"]);
  thing.to = json["to"].text_or("", 100);
  thing.always = json["needs"].text_or("always", 100) == "always";
  return thing;
}

}  // namespace

Result<Occupants> Occupants::parse(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "people", "activities", "where"});
  Occupants result;
  for (const bool is_activity : {false, true})
    for (const auto& [name, entry] : root[is_activity ? "activities" : "people"].members()) {
      entry.allow_only({"about", "names", "count", "clearance", "things", "of nothing"});
      Occupant occupant;
      occupant.name = name;
      occupant.is_activity = is_activity;
      occupant.count = static_cast<int>(entry["count"].integer_or(is_activity ? 0 : 1, 0, most));
      occupant.is_of_nothing = entry["of nothing"].boolean_or(false);
      occupant.clearance = entry["clearance"].number_or(0.0, 0.0, 3.0);
      for (const auto& thing : entry["things"].elements(most))
        occupant.things.push_back(read_thing(thing));
      for (const auto& word : entry["names"].elements(200))
        result.names_.try_emplace(word.text(100), name);
      result.occupants_.try_emplace(name, std::move(occupant));
    }
  for (const auto& [kind, rooms] : root["where"].members())
    for (const auto& room : rooms.elements(100)) result.where_[kind].push_back(room.text(100));
  if (problems.first()) return *problems.first();
  return result;
}

const Result<Occupants>& Occupants::built_in() {
  static const auto occupants = parse(resource(path).value_or("{}"), path);
  return occupants;
}

const Occupant* Occupants::find(std::string_view name) const {
  const auto named = names_.find(name);
  if (named == names_.end()) return nullptr;
  const auto found = occupants_.find(named->second);
  return found == occupants_.end() ? nullptr : &found->second;
}

bool Occupants::belongs(const std::string& kind, const std::string& room_type) const {
  const auto found = where_.find(kind);
  if (found == where_.end()) return true;
  return std::find(found->second.begin(), found->second.end(), room_type) != found->second.end();
}

}  // namespace roomgen::brief
