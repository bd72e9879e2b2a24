#include <limits>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "complexity.h"
#include "roomgen/base/text.h"

namespace roomgen::lab::compose {

namespace {

constexpr const char* complexity_file = "data/program/complexity.json";
constexpr double unbounded = std::numeric_limits<double>::infinity();

ComplexityWords::Pattern pattern_from(const std::string& text) {
  ComplexityWords::Pattern pattern;
  for (const auto& place : split(text, ' ')) pattern.push_back(split(place, '|'));
  return pattern;
}

std::map<std::string, std::vector<std::string>, std::less<>> lists_from(const JsonReader& json) {
  std::map<std::string, std::vector<std::string>, std::less<>> lists;
  if (!json.exists()) return lists;
  for (const auto& [name, words] : json.members())
    for (const auto& word : words.elements()) lists[name].push_back(word.text());
  return lists;
}

Range level_from(const JsonReader& json) {
  const auto bounds = json.elements(2);
  if (bounds.size() != 2) return json.report("expected [least, most]"), Range{};
  return {bounds[0].number_or(0.0, 0.0, 1e6), bounds[1].raw()->is_null() ? unbounded : bounds[1].number(0.0, 1e6)};
}

ComplexityWords::Measure measure_from(const JsonReader& json) {
  json.allow_only({"levels", "patterns", "words"});
  ComplexityWords::Measure measure;
  if (json["levels"].exists())
    for (const auto& [name, level] : json["levels"].members()) measure.levels[name] = level_from(level);
  for (const auto& pattern : json["patterns"].elements()) measure.patterns.push_back(pattern_from(pattern.text()));
  measure.words = lists_from(json["words"]);
  return measure;
}

ComplexityWords words_from(const JsonReader& root) {
  ComplexityWords words;
  words.level_words = lists_from(root["level words"]);
  for (const auto& word : root["denied by"].elements()) words.denied_by.push_back(word.text());
  words.made_up_with = lists_from(root["made up with"]);
  for (const auto& [name, measure] : root["measures"].members()) words.measures[name] = measure_from(measure);
  return words;
}

}  // namespace

const ComplexityWords& complexity_words() {
  static const ComplexityWords words = [] {
    const auto json = parse_json(resource(complexity_file).value_or("{}"), complexity_file);
    if (!json) return ComplexityWords{};
    JsonReader::Problems problems{complexity_file};
    return words_from(JsonReader(*json, problems));
  }();
  return words;
}

}  // namespace roomgen::lab::compose
