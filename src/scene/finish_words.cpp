#include "finish_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

Tone read_tone(const JsonReader& json) {
  const auto v = json.numbers(3, 0.0, 255.0);
  return Eigen::Vector3d(v[0], v[1], v[2]).cast<float>();
}

FinishWords::Words<Tone> read_tones(const JsonReader& json) {
  FinishWords::Words<Tone> tones;
  for (const auto& [word, tone] : json.members()) tones[word] = read_tone(tone);
  return tones;
}

RoomPart read_part(const JsonReader& json) {
  const std::string part = json.text();
  if (part == "floor") return RoomPart::floor;
  if (part == "ceiling") return RoomPart::ceiling;
  if (part != "walls") json.report("\"" + part + "\" is none of floor, walls, ceiling");
  return RoomPart::walls;
}

FinishWords::Words<RoomPart> read_parts(const JsonReader& json) {
  FinishWords::Words<RoomPart> parts;
  for (const auto& [phrase, part] : json.members()) parts[phrase] = read_part(part);
  return parts;
}

Surface read_surface(const std::string& name, const JsonReader& json) {
  json.allow_only({"names", "resembles", "alternating", "pattern", "tone", "second", "roughness",
                   "on floors", "on walls", "on ceilings"});
  Surface surface;
  surface.name = name;
  if (const auto pattern = json["pattern"]; pattern.exists()) {
    surface.pattern = parse_texture_pattern(pattern.text());
    if (!surface.pattern) pattern.report("\"" + pattern.text() + "\" is no pattern");
  }
  surface.tone = read_tone(json["tone"]);
  surface.second = json["second"].exists() ? read_tone(json["second"]) : Tone(0.8f * surface.tone);
  surface.roughness = json["roughness"].number_or(0.9, 0.0, 1.0);
  if (json["alternating"].exists()) surface.alternating = json["alternating"].text();
  const std::pair<const char*, RoomPart> elsewhere[] = {{"on floors", RoomPart::floor},
                                                        {"on walls", RoomPart::walls},
                                                        {"on ceilings", RoomPart::ceiling}};
  for (const auto& [key, part] : elsewhere)
    if (json[key].exists()) surface.instead[part] = json[key].text();
  return surface;
}

std::vector<UsualFinish> read_usual(const JsonReader& json) {
  std::vector<UsualFinish> all;
  for (const auto& element : json.elements(100)) {
    element.allow_only({"rooms", "surface", "tone"});
    UsualFinish usual;
    for (const auto& room : element["rooms"].elements_or_none(100))
      usual.rooms.push_back(room.text());
    usual.surface = element["surface"].text();
    if (element["tone"].exists()) usual.tone = read_tone(element["tone"]);
    all.push_back(std::move(usual));
  }
  if (all.empty() || !all.back().rooms.empty())
    json.report("the last entry must serve for any room");
  return all;
}

template <typename T>
std::optional<T> read_word(const JsonReader& json, const FinishWords::Words<T>& words) {
  if (!json.exists()) return std::nullopt;
  const auto found = words.find(json.text());
  if (found != words.end()) return found->second;
  json.report("\"" + json.text() + "\" is no word of light");
  return std::nullopt;
}

Lighting read_mood(const JsonReader& json, const FinishWords& words) {
  json.allow_only({"hour", "sky", "level", "warmth"});
  Lighting light;
  if (json["hour"].exists()) light.hour = json["hour"].number(0.0, 24.0);
  light.sky = read_word(json["sky"], words.skies);
  light.lux = read_word(json["level"], words.levels);
  light.kelvin = read_word(json["warmth"], words.warmths);
  return light;
}

void read_light(const JsonReader& json, FinishWords& words) {
  json.allow_only({"sky", "level", "warmth", "moods"});
  for (const auto& [word, said] : json["sky"].members())
    for (const Sky sky : {Sky::clear, Sky::cloudy, Sky::overcast, Sky::night})
      if (name(sky) == said.text()) words.skies[word] = sky;
  for (const auto& [word, lux] : json["level"].members()) words.levels[word] = lux.number(0.0, 1e6);
  for (const auto& [word, kelvin] : json["warmth"].members())
    words.warmths[word] = kelvin.number(0.0, 1e5);
  for (const auto& [phrase, mood] : json["moods"].members())
    words.moods[phrase] = read_mood(mood, words);
}

void check_references(const FinishWords& words, const JsonReader& root) {
  const auto check = [&](const std::string& surface, const JsonReader& where) {
    if (!words.surfaces.count(surface)) where.report("\"" + surface + "\" is no surface");
  };
  for (const auto& [name, surface] : words.surfaces) {
    for (const auto& [part, other] : surface.instead) check(other, root["surfaces"][name]);
    if (!surface.alternating.empty()) check(surface.alternating, root["surfaces"][name]);
  }
  for (const auto& [word, substance] : words.substances)
    check(substance.surface, root["substances"][word]);
  for (const auto& [part, entries] : words.usual)
    for (const auto& usual : entries) check(usual.surface, root["usual"]);
}

}  // namespace

const Lighting* FinishWords::mood_at(const std::vector<std::string>& words, std::size_t at,
                                     std::size_t& length) const {
  constexpr std::size_t longest_mood = 3;
  const Lighting* mood = nullptr;
  std::string phrase;
  for (std::size_t n = at; n < std::min(at + longest_mood, words.size()); ++n) {
    phrase += (n > at ? " " : "") + words[n];
    if (const auto found = moods.find(phrase); found != moods.end())
      mood = &found->second, length = n + 1 - at;
  }
  return mood;
}

bool FinishWords::describes(std::string_view word) const {
  return substances.count(word) || basic_colors.count(word) || colors.count(word) ||
         shades.count(word) || surface_names.count(word);
}

Result<FinishWords> parse_finish_words(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "surfaces", "substances", "basic colors", "colors", "further colors",
                   "shades", "fillers", "parts", "alone", "usual", "light"});
  FinishWords words;
  for (const auto& [name, entry] : root["surfaces"].members()) {
    words.surfaces[name] = read_surface(name, entry);
    for (const char* key : {"names", "resembles"})
      for (const auto& phrase : entry[key].elements_or_none(200)) {
        if (!words.surface_names.try_emplace(phrase.text(), name).second)
          phrase.report("\"" + phrase.text() + "\" is named twice");
        if (key == std::string_view("resembles")) words.likenesses.insert(phrase.text());
      }
  }
  for (const auto& [word, entry] : root["substances"].members()) {
    entry.allow_only({"tone", "surface"});
    words.substances[word] = {read_tone(entry["tone"]), entry["surface"].text()};
  }
  words.basic_colors = read_tones(root["basic colors"]);
  words.colors = read_tones(root["colors"]);
  words.further_colors = read_tones(root["further colors"]);
  for (const auto& [word, entry] : root["shades"].members()) {
    entry.allow_only({"towards", "by"});
    words.shades[word] = {read_tone(entry["towards"]), entry["by"].number(0.0, 1.0)};
  }
  for (const auto& word : root["fillers"].elements_or_none(500)) words.fillers.insert(word.text());
  words.parts = read_parts(root["parts"]);
  words.alone = read_parts(root["alone"]);
  read_light(root["light"], words);
  const auto usual = root["usual"];
  usual.allow_only({"floor", "walls", "ceiling"});
  words.usual[RoomPart::floor] = read_usual(usual["floor"]);
  words.usual[RoomPart::walls] = read_usual(usual["walls"]);
  words.usual[RoomPart::ceiling] = read_usual(usual["ceiling"]);
  check_references(words, root);
  if (problems.first()) return *problems.first();
  return words;
}

const FinishWords& finish_words() {
  static const FinishWords built_in = [] {
    auto parsed =
        parse_finish_words(resource("data/materials.json").value_or("{}"), "data/materials.json");
    // A test parses the file; a build whose data is broken has plain rooms.
    return parsed ? *std::move(parsed) : FinishWords{};
  }();
  return built_in;
}

}  // namespace roomgen
