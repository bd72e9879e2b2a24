#include "small_words.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"

namespace roomgen::language {

namespace {

constexpr const char* words_path = "data/language/words.json";

constexpr std::pair<std::string_view, Measure::Side> side_names[] = {
    {"length", Measure::Side::length},       {"width", Measure::Side::width},
    {"depth", Measure::Side::depth},         {"height", Measure::Side::height},
    {"thickness", Measure::Side::thickness}, {"diameter", Measure::Side::diameter},
    {"distance", Measure::Side::distance}};

constexpr std::pair<std::string_view, Determiner> determiner_names[] = {
    {"indefinite", Determiner::indefinite},
    {"definite", Determiner::definite},
    {"possessive", Determiner::possessive},
    {"each", Determiner::each},
    {"all", Determiner::all},
    {"both", Determiner::both},
    {"none", Determiner::no},
    {"any", Determiner::any},
    {"another", Determiner::another}};

template <typename T, std::size_t n>
T named(const std::pair<std::string_view, T> (&names)[n], const JsonReader& json) {
  const std::string text = json.text();
  for (const auto& [name, value] : names)
    if (name == text) return value;
  json.report("\"" + text + "\" is not known here");
  return names[0].second;
}

void read(const JsonReader& json, std::map<std::string, double, std::less<>>& to) {
  for (const auto& [word, value] : json.members()) to[word] = value.number(0, 1e9);
}

void read(const JsonReader& json, Words& to) {
  for (const auto& element : json.elements(2000)) to.insert(element.text());
}

SmallWords read(const JsonReader& root) {
  SmallWords words;
  read(root["numbers"], words.numbers);
  read(root["scales"], words.scales);
  read(root["fractions"], words.fractions);
  read(root["ordinals"], words.ordinals);
  read(root["lengths"], words.lengths);
  read(root["areas"], words.areas);
  read(root["counted quantities"], words.counted_quantities);
  for (const auto& [word, side] : root["dimensions"].members())
    words.sides[word] = named(side_names, side);
  for (const auto& [word, side] : root["comparatives"].members())
    words.comparatives[word] = named(side_names, side);
  for (const auto& [word, kind] : root["determiners"].members())
    words.determiners[word] = named(determiner_names, kind);
  for (const auto& [clitic, word] : root["contractions"].members())
    words.contractions[clitic] = word.text();
  read(root["vague numbers"], words.vague_numbers);
  read(root["pronouns"], words.pronouns);
  read(root["standing alone"], words.standing_alone);
  read(root["negative pronouns"], words.negative_pronouns);
  read(root["relatives"], words.relatives);
  read(root["conjunctions"], words.conjunctions);
  read(root["additions"], words.additions);
  read(root["subordinators"], words.subordinators);
  read(root["negations"], words.negations);
  read(root["be"], words.be);
  read(root["auxiliaries"], words.auxiliaries);
  read(root["verbs of denial"], words.verbs_of_denial);
  read(root["verbs of having"], words.verbs_of_having);
  read(root["compounds"], words.compounds);
  read(root["prepositions"], words.prepositions);
  read(root["prepositions behind things"], words.prepositions_behind_things);
  read(root["sides without a preposition"], words.sides_without_preposition);
  read(root["denying prepositions"], words.denying_prepositions);
  read(root["adverbs"], words.adverbs);
  read(root["quantities"], words.quantities);
  read(root["plurals"], words.plurals);
  read(root["exceptions"], words.exceptions);
  read(root["upper limits"], words.upper_limits);
  read(root["lower limits"], words.lower_limits);
  read(root["excluded upper limits"], words.excluded_upper_limits);
  read(root["excluded lower limits"], words.excluded_lower_limits);
  read(root["upper limits behind"], words.upper_limits_behind);
  read(root["lower limits behind"], words.lower_limits_behind);
  read(root["exact"], words.exact);
  read(root["approximations"], words.approximations);
  read(root["approximations behind"], words.approximations_behind);
  return words;
}

}  // namespace

const SmallWords& small_words() {
  static const SmallWords words = [] {
    const auto json = parse_json(resource(words_path).value_or("{}"), words_path);
    JsonReader::Problems problems{words_path};
    return json ? read(JsonReader(*json, problems)) : SmallWords{};
  }();
  return words;
}

std::size_t longest_run(const Words& phrases, std::span<const Token> tokens, std::size_t at,
                        std::size_t most) {
  std::size_t best = 0;
  std::string phrase;
  for (std::size_t n = 0;
       n < most && at + n < tokens.size() && tokens[at + n].kind == Token::Kind::word; ++n) {
    phrase += (n ? " " : "") + tokens[at + n].text;
    if (phrases.count(phrase)) best = n + 1;
  }
  return best;
}

}  // namespace roomgen::language
