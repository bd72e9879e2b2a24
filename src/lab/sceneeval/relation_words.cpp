#include "relation_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "relation_functions.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

constexpr std::string_view reversed_prefix = "reversed ";

RelationFunction read_function(const JsonReader& json) {
  std::string text = json.text(64);
  RelationFunction function;
  if (text.starts_with(reversed_prefix)) {
    function.reversed = true;
    text = text.substr(reversed_prefix.size());
  }
  const auto colon = text.find(':');
  function.name = text.substr(0, colon);
  if (colon != std::string::npos) function.parameter = text.substr(colon + 1);
  if (!is_relation_function(function.name)) json.report("no function \"" + function.name + "\"");
  return function;
}

std::map<std::string, RelationMeaning, std::less<>> read_meanings(const JsonReader& json) {
  std::map<std::string, RelationMeaning, std::less<>> meanings;
  for (const auto& [word, alternatives] : json.members())
    for (const auto& alternative : alternatives.elements(8)) {
      auto& functions = meanings[word].emplace_back();
      for (const auto& function : alternative.elements(8))
        functions.push_back(read_function(function));
    }
  return meanings;
}

RoomSide read_side(const JsonReader& json) {
  static const std::map<std::string, RoomSide, std::less<>> known = {
      {"north", RoomSide::north}, {"south", RoomSide::south}, {"east", RoomSide::east},
      {"west", RoomSide::west},   {"front", RoomSide::front}, {"rear", RoomSide::rear},
      {"left", RoomSide::left},   {"right", RoomSide::right}, {"middle", RoomSide::middle}};
  const std::string name = json.text(20);
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  json.report("no side \"" + name + "\"");
  return RoomSide::middle;
}

}  // namespace

Result<RelationWords> RelationWords::parse(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "shelves", "objects", "room", "parts of a room"});
  RelationWords result;
  for (const auto& shelf : root["shelves"].elements_or_none(200))
    result.shelves_.insert(shelf.text(100));
  result.objects_ = read_meanings(root["objects"]);
  for (const auto& [part, meanings] : root["room"].members())
    result.room_[part] = read_meanings(meanings);
  const auto parts = root["parts of a room"];
  parts.allow_only({"sides", "shares"});
  for (const auto& [word, sides] : parts["sides"].members())
    for (const auto& side : sides.elements(2)) result.sides_[word].push_back(read_side(side));
  for (const auto& [word, share] : parts["shares"].members())
    result.shares_[word] = share.number(0.0, 1.0);
  if (problems.first()) return *problems.first();
  return result;
}

const RelationWords& RelationWords::built_in() {
  static const RelationWords result = [] {
    auto parsed = parse(resource("data/evaluate/relations.json").value_or("{}"),
                        "data/evaluate/relations.json");
    return parsed ? *std::move(parsed) : RelationWords();  // a test parses the file
  }();
  return result;
}

RelationMeaning RelationWords::between_objects(std::string_view word,
                                               std::string_view anchor) const {
  if (word == "on") {
    std::vector<std::string> pieces = words(anchor);
    // "toy_shelf" is a shelf.
    for (std::size_t first = 0; first < pieces.size(); ++first)
      if (shelves_.count(join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()},
                              " ")))
        return objects_.at("on a shelf");
  }
  const auto found = objects_.find(word);
  return found == objects_.end() ? RelationMeaning() : found->second;
}

RelationMeaning RelationWords::to_room(std::string_view word, std::string_view part) const {
  auto meanings = room_.find(part);
  if (meanings == room_.end()) meanings = room_.find("room");
  if (meanings == room_.end()) return {};
  const auto found = meanings->second.find(word);
  if (found != meanings->second.end()) return found->second;
  if (meanings->first == "room" && part_of_room(word))
    return {{{"in_part_of_room", std::string(word)}}};
  return {};
}

std::optional<PartOfRoom> RelationWords::part_of_room(std::string_view word) const {
  std::vector<std::string> pieces = words(word);
  if (pieces.size() < 2) return std::nullopt;
  const auto share = shares_.find(pieces.back());
  if (share == shares_.end()) return std::nullopt;
  pieces.pop_back();
  PartOfRoom part{{}, share->second};
  for (const auto& piece : pieces) {
    const auto side = sides_.find(piece);
    if (side == sides_.end()) return std::nullopt;
    part.sides.insert(part.sides.end(), side->second.begin(), side->second.end());
  }
  return part;
}

}  // namespace roomgen::lab
