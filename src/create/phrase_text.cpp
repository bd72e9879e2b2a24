#include "phrase_text.h"

#include <algorithm>
#include <cmath>

#include "brief/prompt_words.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/color.h"

namespace roomgen::create {

using design::Token;

bool says_nothing(const std::string& word) {
  const auto& vocabulary = *design::built_in_vocabulary();
  return vocabulary.no_things.count(word) || vocabulary.people_words.count(word) ||
         vocabulary.stops.count(word);
}

PhraseText::PhraseText(const std::string& prompt, const PartForms& parts, const ShapeKinds& kinds)
    : parts_(parts), kinds_(kinds), tokens_(design::tokenize(prompt)) {
  for (const auto& token : tokens_)
    texts_.push_back(token.kind == Token::Kind::word || token.kind == Token::Kind::number
                         ? token.text
                         : std::string(1, ','));
}

bool PhraseText::is(std::size_t at, std::initializer_list<std::string_view> list) const {
  return at < size() && std::find(list.begin(), list.end(), texts_[at]) != list.end();
}

bool PhraseText::starts(std::size_t at, const std::vector<std::string>& phrase) const {
  return at + phrase.size() <= size() &&
         std::equal(phrase.begin(), phrase.end(), texts_.begin() + static_cast<std::ptrdiff_t>(at));
}

std::string PhraseText::joined(std::size_t at, std::size_t length) const {
  const auto from = texts_.begin() + static_cast<std::ptrdiff_t>(at);
  return join({from, from + static_cast<std::ptrdiff_t>(length)}, " ");
}

PhraseText::Run<const ShapeKind*> PhraseText::kind(std::size_t at) const {
  const ShapeKind* kind = nullptr;
  const std::size_t length = kinds_.match(texts_, at, &kind);
  return {length, kind};
}

PhraseText::Run<std::vector<std::string>> PhraseText::part(std::size_t at) const {
  if (const auto found = longest(parts_.labels, at)) return {found.length, *found.meaning};
  // "three-legged"
  if (at >= size() || texts_[at].size() <= 4 || !texts_[at].ends_with("ed")) return {};
  std::string stem = texts_[at].substr(0, texts_[at].size() - 2);
  if (stem.size() > 2 && stem[stem.size() - 1] == stem[stem.size() - 2]) stem.pop_back();
  const auto found = parts_.labels.find(stem);
  if (found == parts_.labels.end()) return {};
  return {1, found->second};
}

PhraseText::Run<std::string> PhraseText::color(std::size_t at) const {
  for (const std::size_t n : {std::size_t{2}, std::size_t{1}}) {
    if (at + n > size()) continue;
    const std::string name = n == 2 ? texts_[at] + texts_[at + 1] : texts_[at];
    if (shape::parse_color(name)) return {n, name};
  }
  return {};
}

std::optional<double> PhraseText::number(std::size_t at) const {
  if (at >= size()) return std::nullopt;
  const Token& token = tokens_[at];
  if (token.kind == Token::Kind::number) return token.value;
  const auto& vocabulary = *design::built_in_vocabulary();
  const auto found = vocabulary.numbers.find(token.text);
  if (found == vocabulary.numbers.end() || vocabulary.vague.count(token.text)) return std::nullopt;
  return found->second;
}

PhraseText::Run<int> PhraseText::count(std::size_t at) const {
  if (is(at, {"half"})) {
    const std::size_t dozen = is(at + 1, {"a"}) ? at + 2 : at + 1;
    if (is(dozen, {"dozen"})) return {dozen + 1 - at, 6};
  }
  if (is(at, {"baker", "baker's", "bakers"}))
    for (const std::size_t dozen : {at + 1, at + 2})
      if (is(dozen, {"dozen"})) return {dozen + 1 - at, 13};
  if (is(at, {"single"}) && part(at + 1)) return {1, 1};
  if (is(at, {"a", "an", "single", "another"})) return {};
  const auto value = number(at);
  if (!value || *value != std::floor(*value)) return {};
  if (tokens_[at].kind == Token::Kind::number && *value > most_count) return {};
  // "a pair of brackets"
  return {is(at + 1, {"of"}) ? std::size_t{2} : std::size_t{1}, static_cast<int>(*value)};
}

}  // namespace roomgen::create
