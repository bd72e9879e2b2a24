#include "vocabulary.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr int max_ancestors = 8;
constexpr std::size_t max_phrase_words = 24;
constexpr double other_child_fit = 0.75;  // a deck chair for who asks for a chair

std::vector<std::string> singular_words(std::string_view text) {
  auto pieces = words(text);
  if (pieces.size() > max_phrase_words) pieces.resize(max_phrase_words);
  for (auto& piece : pieces) piece = singular(piece);
  return pieces;
}

std::string ending(const std::vector<std::string>& pieces, std::size_t first) {
  return join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()}, " ");
}

// Words formed like adjectives say how a thing is even if no list has them: padded, rustic.
bool looks_like_adjective(std::string_view word) {
  static constexpr std::array<std::string_view, 11> endings = {
      "ed", "ish", "ful", "less", "ous", "ive", "ic", "al", "ern", "ian", "able"};
  return word.size() > 4 && word != "table" &&
         std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view e) { return word.ends_with(e); });
}

bool is_number(std::string_view word) {
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word.front()));
}

// "lamp with a shade", "table for six": what follows says how, not what.
std::string_view before_preposition(std::string_view phrase) {
  static constexpr std::array<std::string_view, 12> stops = {
      " with ",    " for ",  " in ", " on ", " from ", " made ",
      " without ", " that ", ",",    "(",    ";",      " by "};
  std::size_t cut = phrase.size();
  for (const auto stop : stops) cut = std::min(cut, phrase.find(stop));
  return phrase.substr(0, cut);
}

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(2000)) texts.push_back(element.text());
  return texts;
}

// The words of a name by which libraries know the kind: "round rug" is a rug there, of which something is said.
std::string naming(std::string_view name, const Kind& stocked) {
  const std::string whole = join(singular_words(name), " ");
  return whole.ends_with(" " + stocked.name) ? stocked.name : whole;
}

}  // namespace

Result<Vocabulary> Vocabulary::parse(std::string_view text, const std::string& source,
                                     const KindTable& kinds) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "families", "modifiers", "fillers"});
  Vocabulary vocabulary(kinds);
  for (const auto& family : root["families"].elements_or_none(500)) {
    auto members = read_texts(family);
    for (const auto& word : members)
      vocabulary.family_of_.try_emplace(word, vocabulary.families_.size());
    vocabulary.families_.push_back(std::move(members));
  }
  for (auto& word : read_texts(root["modifiers"])) vocabulary.modifiers_.insert(std::move(word));
  for (auto& word : read_texts(root["fillers"])) vocabulary.fillers_.insert(std::move(word));
  if (problems.first()) return *problems.first();
  return vocabulary;
}

const Vocabulary& Vocabulary::built_in() {
  static const Vocabulary vocabulary = [] {
    auto parsed = parse(resource("data/vocabulary.json").value_or("{}"), "data/vocabulary.json");
    // A test parses the file; a build whose data is broken has an empty vocabulary.
    return parsed ? *std::move(parsed) : Vocabulary(KindTable::built_in());
  }();
  return vocabulary;
}

const Kind* Vocabulary::find(std::string_view name) const {
  const Kind* kind = kinds_->named(name);
  return kind ? kinds_->by_name(kind->stocked_as) : nullptr;
}

KindPhrase Vocabulary::understand(std::string_view phrase) const {
  if (const Kind* whole = find(phrase)) return {whole->name, naming(phrase, *whole), true};
  std::vector<std::string> pieces;
  for (auto& piece : singular_words(before_preposition(phrase)))
    if (!is_filler(piece)) pieces.push_back(std::move(piece));

  // English puts the kind last: try the longest ending first.
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    const std::string name = ending(pieces, first);
    const Kind* found = find(name);
    if (!found) continue;
    const bool only_modifiers =
        std::all_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first),
                    [&](const std::string& word) { return is_modifier(word); });
    if (only_modifiers) return {found->name, name, true};
    break;
  }
  std::vector<std::string> rest;
  for (const auto& piece : pieces)
    if (&piece == &pieces.back() || !family_of_.count(piece)) rest.push_back(piece);
  return {join(rest, " "), join(rest, " "), false};
}

KindPhrase Vocabulary::understand_name(std::string_view name) const {
  KindPhrase phrase = understand(name);
  if (phrase.known) return phrase;
  const auto pieces = singular_words(before_preposition(name));
  for (std::size_t first = 0; first < pieces.size(); ++first)
    if (const Kind* found = find(ending(pieces, first))) return {found->name, ending(pieces, first), true};
  return phrase;
}

std::vector<std::string> Vocabulary::mentioned(std::string_view text) const {
  constexpr std::size_t longest_name = 4;
  const auto pieces = singular_words(text);
  std::vector<std::string> result;
  for (std::size_t first = 0; first < pieces.size();) {
    std::size_t taken = std::min(longest_name, pieces.size() - first);
    for (; taken > 0; --taken) {
      const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
      const Kind* found = find(join({begin, begin + static_cast<std::ptrdiff_t>(taken)}, " "));
      if (!found) continue;
      result.push_back(found->name);
      break;
    }
    first += std::max<std::size_t>(taken, 1);
  }
  return result;
}

bool Vocabulary::is_a(std::string_view name, std::string_view ancestor) const {
  const Kind* kind = kinds_->by_name(name);
  for (int i = 0; kind && i < max_ancestors; ++i) {
    if (kind->name == ancestor) return true;
    kind = kinds_->by_name(kind->serves);
  }
  return name == ancestor;
}

double Vocabulary::fit(std::string_view have, std::string_view want) const {
  if (have == want) return have.empty() ? 0.0 : 1.0;
  const Kind* wanted = kinds_->by_name(want);
  const Kind* owned = kinds_->by_name(have);
  if (!wanted || !owned) return 0.0;  // what the vocabulary lacks fits itself only
  if (is_a(have, want)) return owned->usual ? 1.0 : other_child_fit;
  double best = 0.0;
  for (const auto& [other, fit] : wanted->substitutes)
    if (is_a(have, other)) best = std::max(best, fit);
  return best;
}

std::vector<std::string> Vocabulary::family(std::string_view word) const {
  std::vector<std::string> result{std::string(word)};
  const auto found = family_of_.find(word);
  if (found == family_of_.end()) return result;
  for (const auto& other : families_[found->second])
    if (other != word) result.push_back(other);
  return result;
}

std::string Vocabulary::family_name(std::string_view word) const {
  const auto found = family_of_.find(word);
  return found == family_of_.end() ? std::string() : families_[found->second].front();
}

bool Vocabulary::is_modifier(std::string_view word) const {
  return modifiers_.count(word) || family_of_.count(word) || is_filler(word) || is_number(word) ||
         looks_like_adjective(word);
}

bool Vocabulary::is_filler(std::string_view word) const {
  return fillers_.count(word) > 0;
}

}  // namespace roomgen
