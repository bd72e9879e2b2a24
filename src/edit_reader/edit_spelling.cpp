#include <algorithm>

#include "kinds/noun_kind.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "roomgen/base/text.h"
#include "wording.h"

namespace roomgen {

namespace {

constexpr std::size_t least_letters = 3;   // of "teh"
constexpr std::size_t long_word = 8;       // may be wrong in two letters

using Words = brief::WordSet;

void add_words(Words& all, const std::string& phrase) {
  for (auto& word : split(phrase, ' ')) all.insert(std::move(word));
}

template <typename Map>
void add_keys(Words& all, const Map& map) {
  for (const auto& [phrase, value] : map) add_words(all, phrase);
}

// What edits are made of.
Words words_of_edits(const EditText& text) {
  Words all = text.words.stops;
  add_keys(all, text.edits.verbs);
  add_keys(all, text.words.placements);
  add_keys(all, text.edits.growth);
  add_keys(all, text.edits.directions);
  add_keys(all, text.edits.room_parts);
  for (const auto* set : {&text.edits.openers, &text.edits.closers, &text.edits.pronouns, &text.edits.auxiliaries,
                          &text.edits.explanations, &text.edits.reasons, &text.edits.except})
    for (const auto& phrase : *set) add_words(all, phrase);
  return all;
}

Words names_of_things(const EditText& text) {
  Words all;
  for (const auto& object : text.scene.objects) add_words(all, object.category);
  return all;
}

bool is_known(const EditText& text, const Words& known, const std::string& word) {
  const auto& english = language::lexicon();
  return known.count(word) || english.has(word) || language::verb(word) || english.has(language::singular(word)) ||
         text.kinds.named(word) || text.words.numbers.count(word);
}

// Of so few letters none may be another one.
bool has_same_letters(std::string a, std::string b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// The only one that is so near; empty if there are several.
std::string nearest(const std::string& word, const Words& names, std::size_t most) {
  std::string best;
  std::size_t fewest = most + 1;
  bool is_clear = false;
  for (const auto& name : names) {
    const std::size_t longer = std::max(name.size(), word.size()), shorter = std::min(name.size(), word.size());
    if (shorter < least_letters || longer - shorter > most || name.front() != word.front()) continue;
    const std::size_t wrong = edit_distance(word, name);
    if (wrong > fewest || (word.size() == least_letters && !has_same_letters(word, name))) continue;
    is_clear = wrong < fewest;
    fewest = wrong;
    best = name;
  }
  return is_clear ? best : "";
}

std::string meant_for(const EditText& text, const Words& known, const Words& things, const std::string& word) {
  const std::size_t most = word.size() >= long_word ? 2 : 1;
  if (auto thing = nearest(word, things, most); !thing.empty()) return thing;
  if (auto thing = nearest(language::singular(word), things, most); !thing.empty()) return language::plural(thing);
  if (auto other = nearest(word, known, 1); !other.empty()) return other;
  const auto kind = misspelt_kind(text.kinds, word);
  return kind.kind && kind.name.front() == word.front() ? kind.name : "";
}

}  // namespace

void correct_spelling(EditText& text) {
  const Words known = words_of_edits(text), things = names_of_things(text);
  for (std::size_t i = 0; i < text.tokens.size(); ++i) {
    auto& token = text.tokens[i];
    if (token.kind != brief::Token::Kind::word || token.text.size() < least_letters ||
        is_known(text, known, token.text))
      continue;
    const std::string right = meant_for(text, known, things, token.text);
    if (!right.empty() && right.find(' ') == std::string::npos) token.text = text.raw[i].text = right;
  }
}

}  // namespace roomgen
