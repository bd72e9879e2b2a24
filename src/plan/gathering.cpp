#include "gathering.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json_reader.h"
#include "base/resource.h"

namespace roomgen::plan {

namespace {

// A word that asks for a composition outweighs all others that would do.
constexpr double of_words = 10.0, of_use = 1.2;

/// data/gathering.json.
struct Gathering {
  std::map<std::string, std::set<std::string>> rooms;  ///< by family
  std::set<std::string> known_rooms;
  std::map<std::string, std::vector<std::string>> words;  ///< by composition
  std::map<std::string, double> usual;
  std::vector<std::string> foci;
};

Gathering read_gathering() {
  Gathering gathering;
  const auto json =
      parse_json(resource("data/gathering.json").value_or("{}"), "data/gathering.json");
  JsonReader::Problems problems("data/gathering.json");
  const JsonReader root(*json, problems);
  for (const auto& [family, rooms] : root["rooms"].members())
    for (const auto& room : rooms.elements()) {
      gathering.rooms[family].insert(room.text());
      gathering.known_rooms.insert(room.text());
    }
  for (const auto& kind : root["focus"].elements()) gathering.foci.push_back(kind.text());
  for (const auto& [name, one] : root["compositions"].members()) {
    one.allow_only({"words", "usual"});
    for (const auto& word : one["words"].elements_or_none())
      gathering.words[name].push_back(word.text());
    gathering.usual[name] = one["usual"].number_or(1.0, 0, 10);
  }
  assert(!problems.first());
  return gathering;
}

const Gathering& gathering() {
  static const Gathering read = read_gathering();
  return read;
}

}  // namespace

const std::vector<std::string>& usual_foci() {
  return gathering().foci;
}

double readiness(const composition::Composition& composition, const std::string& room,
                 const std::string& wish) {
  const Gathering& gathering = plan::gathering();
  if (const auto words = gathering.words.find(composition.name); words != gathering.words.end())
    for (const auto& word : words->second)
      if (wish.find(word) != std::string::npos) return of_words;
  const auto rooms = gathering.rooms.find(composition.family);
  if (gathering.known_rooms.count(room) &&
      (rooms == gathering.rooms.end() || !rooms->second.count(room)))
    return 0.0;
  const auto usual = gathering.usual.find(composition.name);
  const auto& uses = composition.uses;
  const bool is_meant = std::find(uses.begin(), uses.end(), room) != uses.end();
  return (usual == gathering.usual.end() ? 1.0 : usual->second) * (is_meant ? of_use : 1.0);
}

}  // namespace roomgen::plan
