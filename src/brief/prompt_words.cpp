#include "prompt_words.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "scene/relation_table.h"

namespace roomgen::brief {

namespace {

WordSet read_set(const JsonReader& json) {
  WordSet words;
  for (const auto& element : json.elements_or_none(2000)) words.insert(element.text());
  return words;
}

std::map<std::string, int, std::less<>> read_integers(const JsonReader& json) {
  std::map<std::string, int, std::less<>> map;
  for (const auto& [word, value] : json.members())
    map[word] = static_cast<int>(value.integer_or(0, 0, 1000));
  return map;
}

Placement read_placement(const JsonReader& json) {
  Placement placement;
  for (const auto& element : json.elements(10)) {
    std::string word = element.text();
    if (word.starts_with("+")) {
      placement.inverse = true;
      word.erase(0, 1);
    }
    if (word == "it") {
      placement.pronoun = true;
      continue;
    }
    if (word == "~it") {
      placement.adverb = true;
      continue;
    }
    if (word == "middle") {
      placement.centered = true;
      continue;
    }
    if (word == "hanging") {
      placement.hanging = true;
      continue;
    }
    if (word == "each") {
      placement.mutual = true;
      continue;
    }
    if (word == "sit") {
      placement.seated = true;
      continue;
    }
    if (word == "pairs") {
      placement.paired = true;
      continue;
    }
    if (word == "flank") {
      placement.flank = true;
      continue;
    }
    if (word.starts_with("of ")) {
      placement.owner = word.substr(3);
      continue;
    }
    auto relation = parse_relation(word + ", target");
    if (relation)
      placement.relations.push_back(relation->kind);
    else
      element.report(relation.error().message);
  }
  return placement;
}

// "circle", "arc"; "circle of 3" where no other number is so called.
FormationWord read_round_formation(const JsonReader& json) {
  const std::string name = json.text();
  if (name == "circle") return {Formation::Shape::circle, 0};
  if (name == "arc") return {Formation::Shape::arc, 0};
  if (name == "circle of 3") return {Formation::Shape::circle, 3};
  if (name == "circle of 4") return {Formation::Shape::circle, 4};
  if (name == "islands") return {Formation::Shape::islands, 4};
  if (name == "islands of 2") return {Formation::Shape::islands, 2};
  json.report("must be \"circle\", \"arc\", \"circle of 3\", \"circle of 4\", \"islands\" or \"islands of 2\"");
  return {};
}

}  // namespace

Result<Vocabulary> parse_vocabulary(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about",          "numbers",
                   "vague",          "definite",
                   "negations",      "limits",
                   "exceptions",     "anything",
                   "measured",       "distances",
                   "stops",          "parts",
                   "no things",      "materials",
                   "sizes",          "people",
                   "people words",   "room words",
                   "generic rooms",  "parts of rooms",
                   "walls",          "placements",
                   "pairs",          "diagonals",
                   "manners",        "verbs",
                   "spreads",        "tops",
                   "portions",       "built in",
                   "asking",         "further",
                   "shares",         "wall lengths",
                   "groups",         "areas",
                   "rows",           "round formations",
                   "palette frames", "height beginnings",
                   "height endings", "courtesies",
                   "full heights"});
  Vocabulary words;
  words.numbers = read_integers(root["numbers"]);
  words.people = read_integers(root["people"]);
  words.walls = read_integers(root["walls"]);
  words.spreads = read_integers(root["spreads"]);
  for (const auto& [word, scale] : root["sizes"].members()) {
    const auto v = scale.numbers(3, 0.1, 5.0);
    words.sizes[word] = {v[0], v[1], v[2]};
  }
  for (const auto& [word, part] : root["parts of rooms"].members())
    words.room_parts[word] = part.text();
  for (const auto& [word, share] : root["shares"].members()) words.shares[word] = share.text();
  for (const auto& [word, length] : root["wall lengths"].members()) words.wall_lengths[word] = length.text();
  for (const auto& [word, meaning] : root["limits"].members()) words.limits[word] = meaning.text();
  for (const auto& [word, shape] : root["round formations"].members()) words.round_formations[word] = read_round_formation(shape);
  for (const auto& relation : relation_definitions())
    if (relation.has(RelationDefinition::in_prompts)) words.placements[std::string(relation.name())].relations = {relation.kind};
  for (const auto& [phrase, relations] : root["placements"].members())
    words.placements[phrase] = read_placement(relations);
  const std::pair<const char*, WordSet*> sets[] = {{"vague", &words.vague},
                                                   {"definite", &words.definite},
                                                   {"negations", &words.negations},
                                                   {"anything", &words.anything},
                                                   {"exceptions", &words.exceptions},
                                                   {"measured", &words.measured},
                                                   {"distances", &words.distances},
                                                   {"stops", &words.stops},
                                                   {"parts", &words.parts},
                                                   {"no things", &words.no_things},
                                                   {"materials", &words.materials},
                                                   {"people words", &words.people_words},
                                                   {"room words", &words.room_words},
                                                   {"generic rooms", &words.generic_rooms},
                                                   {"pairs", &words.pairs},
                                                   {"diagonals", &words.diagonals},
                                                   {"manners", &words.manners},
                                                   {"verbs", &words.verbs},
                                                   {"tops", &words.tops},
                                                   {"portions", &words.portions},
                                                   {"built in", &words.built_in},
                                                   {"asking", &words.asking},
                                                   {"further", &words.further},
                                                   {"groups", &words.groups},
                                                   {"areas", &words.areas},
                                                   {"rows", &words.rows},
                                                   {"height beginnings", &words.height_beginnings},
                                                   {"full heights", &words.full_heights},
                                                   {"courtesies", &words.courtesies},
                                                   {"height endings", &words.height_endings},
                                                   {"palette frames", &words.palette_frames}};
  for (const auto& [key, set] : sets) *set = read_set(root[key]);
  if (problems.first()) return *problems.first();
  return words;
}

const Result<Vocabulary>& built_in_vocabulary() {
  static const auto words =
      parse_vocabulary(resource("data/words.json").value_or("{}"), "data/words.json");
  return words;
}

std::size_t longest_in(const WordSet& phrases, std::span<const Token> tokens, std::size_t at) {
  constexpr std::size_t most = 7;  // words
  std::size_t best = 0;
  std::string phrase;
  for (std::size_t n = 0; n < most && at + n < tokens.size(); ++n) {
    const auto& token = tokens[at + n];
    if (token.kind != Token::Kind::word && token.kind != Token::Kind::number) break;
    phrase += (n ? " " : "") + token.text;
    if (phrases.count(phrase)) best = n + 1;
  }
  return best;
}

}  // namespace roomgen::brief
