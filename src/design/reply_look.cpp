#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "chat/loose_json.h"
#include "plan/floor_plan.h"
#include "plan_answers.h"
#include "scene/room_look_json.h"
#include "scene/wanted_opening_json.h"

namespace roomgen::design {

namespace {

// Without members that are null, and texts that are empty, at any depth: what an answer leaves open.
Json said_part(const Json& value) {
  if (!value.is_structured()) return value;
  Json kept = value.is_array() ? Json::array() : Json::object();
  for (const auto& [key, inner] : value.items()) {
    if (inner.is_null() || inner == "") continue;
    Json part = said_part(inner);
    if (value.is_array()) kept.push_back(std::move(part));
    else if (!(part.is_structured() && part.empty())) kept[key] = std::move(part);
  }
  return kept;
}

void note(const JsonReader::Problems& problems, std::vector<std::string>& repairs) {
  if (problems.first()) repairs.push_back(problems.first()->message);
  repairs.insert(repairs.end(), problems.remarks().begin(), problems.remarks().end());
}

}  // namespace

void read_reply_look(const Json& json, Room& room, std::vector<std::string>& repairs) {
  // One that is wrong costs none of the others.
  for (const char* key : {"materials", "light", "style", "palette"}) {
    const Json* said = member(room_part(json), {key});
    if (!said) continue;
    const Json part = {{key, said_part(*said)}};
    JsonReader::Problems problems("room");
    Room with;
    with.polygon = room.polygon;
    with.height = room.height;
    read_look(JsonReader(part, problems), FileWalls(room.polygon.points, room.polygon), with);
    note(problems, repairs);
    if (problems.first()) continue;
    const std::string name = key;
    if (name == "materials") plan::put_on(room, with.materials);
    else if (name == "light") room.light = with.light;
    else if (name == "style") room.style = with.style;
    else room.palette = with.palette;
  }
}

std::vector<WantedOpening> read_reply_openings(const Json& json, const Room& room,
                                               std::vector<std::string>& repairs) {
  const Json* said = member(json, {"openings", "doors and windows"});
  if (!said) said = member(room_part(json), {"openings"});
  if (!said || !said->is_array()) return {};
  std::vector<WantedOpening> openings;
  for (std::size_t i = 0; i < said->size(); ++i) {
    const Json one = Json::array({said_part((*said)[i])});
    JsonReader::Problems problems("openings/" + std::to_string(i));
    auto read = read_wanted_openings(JsonReader(one, problems), room.polygon.points, room);
    note(problems, repairs);
    if (!problems.first()) openings.insert(openings.end(), read.begin(), read.end());
  }
  return openings;
}

}  // namespace roomgen::design
