#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

namespace {

constexpr std::string_view vocabulary_file = "data/program/vocabulary.json";

using Words = std::map<std::string, std::vector<std::string>, std::less<>>;

Words read_words(const JsonReader& json) {
  Words words;
  for (const auto& [word, kinds] : json.members())
    for (const auto& kind : kinds.elements()) words[word].push_back(kind.text());
  return words;
}

using Sitters = ProgramVocabulary::Sitters;

std::map<std::string, Sitters, std::less<>> read_seats(const JsonReader& json) {
  std::map<std::string, Sitters, std::less<>> seats;
  for (const auto& [kind, sitters] : json.members())
    seats[kind] = {static_cast<int>(sitters["people"].integer_or(0, 0, 100)), sitters["metres"].number_or(0.0, 0.0, 10.0)};
  return seats;
}

// Of a kind and its ancestors the nearest one that is listed decides.
bool covers(const std::vector<std::string>& listed, const Kind& kind) {
  const auto lists = [&](const std::string& name) {
    return std::find(listed.begin(), listed.end(), name) != listed.end();
  };
  for (const auto& name : kind.lineage) {
    if (lists(name)) return true;
    if (lists("-" + name)) return false;
  }
  return false;
}

}  // namespace

const ProgramVocabulary& ProgramVocabulary::built_in() {
  static const ProgramVocabulary vocabulary = [] {
    const std::string source(vocabulary_file);
    const auto json = parse_json(resource(source).value_or(""), source);
    if (!json) return ProgramVocabulary{};
    JsonReader::Problems problems(source);
    const JsonReader root(*json, problems);
    return ProgramVocabulary{read_words(root["tags"]), read_words(root["factories"]),
                             read_seats(root["seats"])};
  }();
  return vocabulary;
}

int seats_on(const ProgramVocabulary& vocabulary, const Kind& kind, double width) {
  constexpr double rounding = 1e-6;
  for (const auto& name : kind.lineage)
    if (const auto found = vocabulary.seats.find(name); found != vocabulary.seats.end()) {
      const auto& [people, metres] = found->second;
      return metres > 0.0 ? std::max(people, static_cast<int>(width / metres + rounding)) : people;
    }
  return 0;
}

bool has_tag(const ProgramVocabulary& vocabulary, const Kind& kind, std::string_view tag) {
  const auto found = vocabulary.tags.find(tag);
  return found != vocabulary.tags.end() && covers(found->second, kind);
}

bool is_made_by(const ProgramVocabulary& vocabulary, const KindTable& kinds, const Kind& kind,
                std::string_view factory) {
  const auto found = vocabulary.factories.find(factory);
  if (found != vocabulary.factories.end()) return covers(found->second, kind);
  std::string name(factory);
  std::replace(name.begin(), name.end(), '_', ' ');
  const Kind* made = kinds.by_name(name);
  return made && is_of(kind, made->name);
}

}  // namespace roomgen::lab
