#include "dwelling_kinds.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"

namespace roomgen::brief {

namespace {

constexpr int max_hub = 10;

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(200)) texts.push_back(element.text(100));
  return texts;
}

DwellingRoom read_dwelling_room(const JsonReader& json) {
  json.allow_only({"hub", "wing", "area", "passage", "owns"});
  DwellingRoom room;
  room.hub = static_cast<int>(json["hub"].integer_or(0, 0, max_hub));
  const std::string wing = json["wing"].text_or("day");
  if (wing != "day" && wing != "night") json["wing"].report("must be \"day\" or \"night\"");
  room.night = wing == "night";
  const auto area = json["area"].numbers(2, 1.0, 100.0);
  room.area = {area[0], area[1]};
  if (area[0] > area[1]) json["area"].report("must be [low, high]");
  room.passage = read_texts(json["passage"]);
  room.owns = read_texts(json["owns"]);
  return room;
}

}  // namespace

Result<DwellingKinds> parse_dwelling_kinds(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "dwellings", "never without", "links", "no rooms", "rooms"});
  DwellingKinds kinds;
  for (const auto& [noun, usual] : root["dwellings"].members())
    kinds.dwellings[noun] = read_texts(usual);
  kinds.never_without = read_texts(root["never without"]);
  for (const auto& link : read_texts(root["links"])) kinds.links[link] = 1;
  for (const auto& name : read_texts(root["no rooms"])) kinds.no_rooms.insert(name);
  for (const auto& [type, entry] : root["rooms"].members()) kinds.rooms[type] = read_dwelling_room(entry);
  if (problems.first()) return *problems.first();
  return kinds;
}

const Result<DwellingKinds>& built_in_dwelling_kinds() {
  static const auto kinds = parse_dwelling_kinds(
      resource("data/dwellings.json").value_or("{}"), "data/dwellings.json");
  return kinds;
}

}  // namespace roomgen::brief
