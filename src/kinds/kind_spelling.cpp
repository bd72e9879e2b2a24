#include "noun_kind.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <vector>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t least_length = 4;  // shorter words are too near to many others
constexpr std::size_t long_word = 8;     // may be wrong in two letters
constexpr std::size_t most_of_plural = 3;   // letters that it changes: "child", "children"
constexpr std::size_t most_difference = 5;  // of a noun and a name: two letters, and those of the plural

// "Charging" is a form of a common verb; "dinning", of one that hardly anybody uses, is rather a slip.
bool is_english(const std::string& word) {
  const auto& english = language::lexicon();
  if (english.has(word) || english.has(language::singular(word))) return true;
  const auto verb = language::verb(word);
  constexpr double common = 3.0;
  return verb && english.tagged(verb->base, language::PartOfSpeech::verb) >= common;
}

// None of a word that is right, or that is too short.
std::size_t most_edits(const std::string& word) {
  if (word.size() < least_length || is_english(word)) return 0;
  return word.size() >= long_word ? 2 : 1;
}

/// A noun as it was said, and how many letters of each word may be wrong.
struct Said {
  std::vector<std::string> words;
  std::vector<std::size_t> most_edits;
};

/// Tells of most names, and quickly, that a noun does not mean them: they are too long or too short, or have other
/// letters, each of which would be an edit.
class Glance {
 public:
  Glance(std::string_view noun, const Said& said) : size_(noun.size()), most_other_(most_of_plural) {
    for (const std::size_t edits : said.most_edits) most_other_ += edits;
    for (const char letter : noun) ++letters_[index(letter)];
  }

  bool may_mean(std::string_view name) const {
    const auto [shorter, longer] = std::minmax({size_, name.size()});
    if (longer - shorter > most_difference) return false;
    auto left = letters_;
    std::size_t other = 0;
    for (const char letter : name)
      if (letter != ' ' && letter != '-' && left[index(letter)]-- <= 0) ++other;
    return other <= most_other_;
  }

 private:
  // Cases are the same; so are some other letters, which then look more alike than they are.
  static std::size_t index(char letter) { return static_cast<unsigned char>(letter) % 32u; }

  std::size_t size_;
  std::size_t most_other_;
  std::array<int, 32> letters_{};
};

// Nothing if a word that is right, or another one, would have to change.
std::optional<std::size_t> edits_of_words(const Said& said, const std::vector<std::string>& name) {
  if (said.words.size() != name.size()) return std::nullopt;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const std::string& word = said.words[i];
    if (word == name[i]) continue;
    const auto [shorter, longer] = std::minmax({word.size(), name[i].size()});
    if (said.most_edits[i] == 0 || longer - shorter > said.most_edits[i]) return std::nullopt;
    const std::size_t wrong = edit_distance(word, name[i]);
    if (wrong > said.most_edits[i]) return std::nullopt;
    sum += wrong;
  }
  return sum;
}

}  // namespace

NounKind misspelt_kind(const KindTable& table, std::string_view noun) {
  Said said{words(noun), {}};
  if (std::all_of(said.words.begin(), said.words.end(), is_english)) return {};
  std::transform(said.words.begin(), said.words.end(), std::back_inserter(said.most_edits), most_edits);
  const bool is_plural = said.words.back().ends_with('s');
  NounKind best;
  std::size_t fewest = noun.size();
  bool is_clear = false;
  const Glance glance(noun, said);
  const auto compare = [&](const std::string& name, const Kind& kind) {
    if (!glance.may_mean(name)) return;
    const auto named = words(name);
    if (named.size() != said.words.size()) return;
    auto wrong = edits_of_words(said, named);
    if (!wrong && is_plural) wrong = edits_of_words(said, words(language::plural(name)));
    if (!wrong || *wrong > fewest) return;
    const Kind* meant = &table.planned(kind);
    is_clear = *wrong < fewest || (is_clear && meant == best.kind);
    fewest = *wrong;
    best = {meant, NounBasis::spelling, name};
  };
  for (const auto& [own, kind] : table.all()) {
    compare(own, kind);
    for (const auto& name : kind.names) compare(name, kind);
  }
  return is_clear ? best : NounKind{};
}

}  // namespace roomgen
