#include "edit_vocabulary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double most = 1e4;

std::string joined_words(const std::string& first, const std::string& second) {
  return first.empty() ? second : second.empty() ? first : first + " " + second;
}

std::vector<std::string> each_with_each(const std::vector<std::string>& before,
                                        const std::vector<std::string>& choices) {
  std::vector<std::string> all;
  for (const auto& start : before)
    for (const auto& choice : choices) all.push_back(joined_words(start, choice));
  return all;
}

/// The phrases that a pattern stands for: "(could|can) you (please|)" gives "could you please", "could you",
/// "can you please", "can you". Brackets do not nest.
std::vector<std::string> phrases_of(std::string_view pattern) {
  std::vector<std::string> phrases = {""};
  while (!pattern.empty()) {
    const bool is_choice = pattern.front() == '(';
    if (is_choice) pattern.remove_prefix(1);
    const std::size_t end = std::min(pattern.find(is_choice ? ')' : '('), pattern.size());
    phrases = each_with_each(phrases, is_choice ? split(pattern.substr(0, end), '|')
                                                : std::vector{std::string(trim(pattern.substr(0, end)))});
    pattern.remove_prefix(std::min(end + (is_choice ? 1 : 0), pattern.size()));
  }
  return phrases;
}

EditVocabulary::Set set_of(const JsonReader& json) {
  EditVocabulary::Set set;
  for (const auto& element : json.elements(1000))
    for (auto& phrase : phrases_of(element.text(400))) set.insert(std::move(phrase));
  return set;
}

template <typename T, typename Read>
EditVocabulary::Map<T> map_of(const JsonReader& json, Read read) {
  EditVocabulary::Map<T> map;
  for (const auto& [pattern, value] : json.members())
    for (const auto& phrase : phrases_of(pattern)) map[phrase] = read(value);
  return map;
}

double number_of(const JsonReader& json) { return json.number(-most, most); }
std::string text_of(const JsonReader& json) { return json.text(100); }

Vec2 direction_of(const JsonReader& json) {
  const auto v = json.numbers(2, -1.0, 1.0);
  return {v[0], v[1]};
}

Growth growth_of(const JsonReader& json) {
  const auto parts = json.elements(2);
  if (parts.size() != 2) return json.report("expected a side and a factor"), Growth();
  return {parts[0].text(20), parts[1].number(0.1, 10.0)};
}

EditVocabulary::Map<std::string> verbs_of(const JsonReader& json) {
  EditVocabulary::Map<std::string> verbs;
  for (const auto& [meaning, phrases] : json.members())
    for (const auto& pattern : phrases.elements(200))
      for (const auto& phrase : phrases_of(pattern.text(400))) verbs[phrase] = meaning;
  return verbs;
}

Result<EditVocabulary> read_edit_vocabulary() {
  const auto json = parse_json(resource("data/edits.json").value_or("{}"), "data/edits.json");
  if (!json) return json.error();
  JsonReader::Problems problems("data/edits.json");
  const JsonReader root(*json, problems);
  EditVocabulary words;
  words.verbs = verbs_of(root["verbs"]);
  const std::pair<const char*, EditVocabulary::Set*> sets[] = {{"openers", &words.openers},
                                                               {"closers", &words.closers},
                                                               {"explanations", &words.explanations},
                                                               {"pronouns", &words.pronouns},
                                                               {"just added", &words.just_added},
                                                               {"all", &words.all},
                                                               {"everything", &words.everything},
                                                               {"except", &words.except},
                                                               {"more", &words.more},
                                                               {"nearest", &words.nearest},
                                                               {"away", &words.away},
                                                               {"closer", &words.closer},
                                                               {"to", &words.to},
                                                               {"so that it faces", &words.faces},
                                                               {"where they are", &words.where_they_are},
                                                               {"back", &words.back},
                                                               {"words of looks", &words.words_of_looks},
                                                               {"stays", &words.stays},
                                                               {"emphasis", &words.emphasis},
                                                               {"hedges", &words.hedges},
                                                               {"modals", &words.modals},
                                                               {"goes away", &words.goes_away},
                                                               {"properties", &words.properties},
                                                               {"refused", &words.refused},
                                                               {"auxiliaries", &words.auxiliaries},
                                                               {"requests", &words.requests},
                                                               {"reasons", &words.reasons},
                                                               {"substitutes", &words.substitutes},
                                                               {"whole room", &words.whole_room},
                                                               {"whole dwelling", &words.whole_dwelling},
                                                               {"along with it", &words.along},
                                                               {"farthest", &words.farthest},
                                                               {"being", &words.being},
                                                               {"not being", &words.not_being},
                                                               {"presently", &words.presently},
                                                               {"place of", &words.place_of},
                                                               {"there", &words.there},
                                                               {"at parts", &words.at_parts},
                                                               {"space", &words.space},
                                                               {"around space", &words.around_space},
                                                               {"gap to", &words.gap_to},
                                                               {"one each", &words.one_each},
                                                               {"each corner", &words.each_corner},
                                                               {"as possible", &words.possible},
                                                               {"middles", &words.middles},
                                                               {"besides", &words.besides},
                                                               {"each other", &words.each_other},
                                                               {"side by side", &words.side_by_side},
                                                               {"corrections", &words.corrections},
                                                               {"questions", &words.questions},
                                                               {"welcome", &words.welcome},
                                                               {"own", &words.own},
                                                               {"suffices", &words.suffices},
                                                               {"only these", &words.only_these},
                                                               {"like it", &words.like_it},
                                                               {"something", &words.something},
                                                               {"existing", &words.existing},
                                                               {"likewise", &words.likewise},
                                                               {"shapes", &words.shapes},
                                                               {"vice versa", &words.vice_versa},
                                                               {"particles", &words.particles},
                                                               {"made of", &words.made_of},
                                                               {"unneeded", &words.unneeded},
                                                               {"facing away", &words.facing_away},
                                                               {"up to the ceiling", &words.up_to_ceiling},
                                                               {"courtesies", &words.courtesies},
                                                               {"short is before", &words.short_is_before},
                                                               {"too", &words.too},
                                                               {"in the way of", &words.in_the_way_of},
                                                               {"the wrong way", &words.wrong_way},
                                                               {"further on", &words.further_on},
                                                               {"the others", &words.others},
                                                               {"denials", &words.denials},
                                                               {"wishes", &words.wishes},
                                                               {"apart", &words.apart},
                                                               {"centred", &words.centred},
                                                               {"other side", &words.other_side},
                                                               {"better", &words.betters},
                                                               {"who tells", &words.tellers},
                                                               {"told how", &words.told_how},
                                                               {"told deeds", &words.told_deeds},
                                                               {"negations", &words.negations}};
  for (const auto& [key, set] : sets) *set = set_of(root[key]);
  words.sides = map_of<Vec2>(root["sides"], direction_of);
  words.directions = map_of<Vec2>(root["directions"], direction_of);
  words.side_tails = map_of<Vec2>(root["behind a noun"], direction_of);
  words.sides_of_things = map_of<Vec2>(root["sides of things"], direction_of);
  words.parts_of_things = map_of<Vec2>(root["parts of things"], direction_of);
  words.lifts = map_of<double>(root["lifts"], number_of);
  words.sizes = map_of<double>(root["sizes of things"], number_of);
  words.heights = map_of<double>(root["heights"], number_of);
  words.amounts = map_of<double>(root["amounts"], number_of);
  words.wall_ways = map_of<double>(root["ways of walls"], number_of);
  words.shares = map_of<double>(root["shares"], number_of);
  words.turns = map_of<double>(root["turns"], number_of);
  words.turn_directions = map_of<double>(root["turn directions"], number_of);
  words.growth = map_of<Growth>(root["growth"], growth_of);
  words.verbs_of_size = map_of<Growth>(root["verbs of size"], growth_of);
  words.measured = map_of<std::string>(root["measured"], text_of);
  words.places = map_of<std::string>(root["places"], text_of);
  words.contractions = map_of<std::string>(root["contractions"], text_of);
  words.clitics = map_of<std::string>(root["clitics"], text_of);
  words.degrees = map_of<double>(root["degrees"], number_of);
  words.own_ways = map_of<double>(root["own ways"], number_of);
  words.rewordings = map_of<std::string>(root["rewordings"], text_of);
  words.counts = map_of<double>(root["counts"], number_of);
  words.multiples = map_of<double>(root["multiples"], number_of);
  words.room_parts = map_of<std::string>(root["room parts"], text_of);
  if (problems.first()) return *problems.first();
  return words;
}

}  // namespace

const Result<EditVocabulary>& edit_vocabulary() {
  static const auto words = read_edit_vocabulary();
  return words;
}

}  // namespace roomgen
