#include "noun_kind.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t least_length = 4;  // shorter words are too near to many others
constexpr std::size_t long_word = 8;     // may be wrong in two letters
constexpr std::size_t most_difference = 5;  // of a noun and a name: two letters, and those of the plural

bool is_english(const std::string& word) {
  const auto& english = language::lexicon();
  return english.has(word) || english.has(language::singular(word));
}

std::size_t most_edits(std::string_view word) {
  return word.size() >= long_word ? 2 : 1;
}

// Most names are too long or too short to be meant.
bool may_be_meant(std::string_view said, std::string_view name) {
  const auto [shorter, longer] = std::minmax({said.size(), name.size()});
  return longer - shorter <= most_difference;
}

// Nothing if a word that is right, or another one, would have to change.
std::optional<std::size_t> edits_of_words(const std::vector<std::string>& said, const std::vector<std::string>& name) {
  if (said.size() != name.size()) return std::nullopt;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (said[i] == name[i]) continue;
    const auto [shorter, longer] = std::minmax({said[i].size(), name[i].size()});
    if (longer - shorter > most_edits(said[i]) || said[i].size() < least_length || is_english(said[i]))
      return std::nullopt;
    const std::size_t wrong = edit_distance(said[i], name[i]);
    if (wrong > most_edits(said[i])) return std::nullopt;
    sum += wrong;
  }
  return sum;
}

}  // namespace

NounKind misspelt_kind(const KindTable& table, std::string_view noun) {
  const auto said = words(noun);
  if (said.empty() || std::all_of(said.begin(), said.end(), is_english)) return {};
  const bool is_plural = said.back().ends_with('s');
  NounKind best;
  std::size_t fewest = noun.size();
  bool is_clear = false;
  const auto compare = [&](const std::string& name, const Kind& kind) {
    if (!may_be_meant(noun, name)) return;
    auto wrong = edits_of_words(said, words(name));
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
