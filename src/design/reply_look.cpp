#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "chat/loose_json.h"
#include "plan/floor_plan.h"
#include "plan_answers.h"
#include "roomgen/base/text.h"
#include "scene/room_look_json.h"
#include "scene/wanted_opening_json.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_name = 40;  ///< bytes of an opening's kind in a note

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

// Models are told places in words: "/walls/0/finish: must be text" of the materials is "the
// materials, walls 1, finish: must be text".
std::string in_words(const std::string& message, const std::string& of) {
  if (message.starts_with(": ")) return in_words(message.substr(2), of);
  const std::size_t colon = message.find(": ");
  if (!message.starts_with("/") || colon == std::string::npos) return of + ": " + message;
  std::string told = of;
  for (const auto& step : split(message.substr(1, colon - 1), '/')) {
    const bool is_number = !step.empty() && step.find_first_not_of("0123456789") == step.npos;
    told += is_number ? " " + std::to_string(std::stoul(shortened(step, 6)) + 1) : ", " + step;
  }
  return told + message.substr(colon);
}

void note(const JsonReader::Problems& problems, const std::string& of,
          std::vector<std::string>& repairs) {
  if (problems.first()) repairs.push_back(in_words(problems.first()->message, of));
  for (const auto& remark : problems.remarks()) repairs.push_back(in_words(remark, of));
}

}  // namespace

void read_reply_look(const Json& json, Room& room, std::vector<std::string>& repairs) {
  // One that is wrong costs none of the others.
  for (const char* key : {"materials", "light", "style", "palette"}) {
    const Json* said = member(room_part(json), {key});
    if (!said) continue;
    const Json part = {{key, said_part(*said)}};
    JsonReader::Problems problems("");
    Room with;
    with.polygon = room.polygon;
    with.height = room.height;
    read_look(JsonReader(part, problems), FileWalls(room.polygon.points, room.polygon), with);
    note(problems, "the room", repairs);
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
    JsonReader::Problems problems("");
    auto read = read_wanted_openings(JsonReader(one, problems), room.polygon.points, room);
    const std::string kind = one[0].is_object() ? text_in(member(one[0], {"kind"})) : "";
    const std::string called = kind.empty() ? "" : " (" + shortened(kind, max_name) + ")";
    std::vector<std::string> notes;
    note(problems, "opening", notes);
    for (auto& told : notes)
      repairs.push_back("opening " + std::to_string(i + 1) + called +
                        told.substr(told.find_first_of(",:")));
    if (!problems.first()) openings.insert(openings.end(), read.begin(), read.end());
  }
  return openings;
}

}  // namespace roomgen::design
