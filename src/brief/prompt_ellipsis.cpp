#include <algorithm>

#include "language/lexicon.h"
#include "phrase_readers.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Determiner;
using language::NounPhrase;

bool is_look(const PromptReading& reading, std::uint32_t token) {
  const std::string& word = reading.word(token);
  return finish_words().describes(word) || reading.words.sizes.count(word) > 0 ||
         language::lexicon().has(word, language::PartOfSpeech::adjective);
}

bool is_number(const PromptReading& reading, std::uint32_t token) {
  return reading.text.plain[token].kind == Token::Kind::number || reading.words.numbers.count(reading.word(token)) > 0;
}

// "a", "two": introduces something, and is no "the" and no "another".
bool introduces(const NounPhrase& said) {
  return said.determiner == Determiner::indefinite || (said.determiner == Determiner::absent && said.count > 0);
}

// The looks that a phrase is nothing but; none if it has a noun, or says less or more.
std::vector<std::uint32_t> looks_alone(const PromptReading& reading, std::int32_t id) {
  const NounPhrase& said = reading.phrase(id);
  if (!introduces(said) || reading.is_taken(said) || reading.thing(id).kind.length > 0) return {};
  std::vector<std::uint32_t> looks;
  for (auto i = said.tokens.begin; i < said.tokens.end; ++i) {
    if (is_number(reading, i) || reading.is_word(i, "and")) continue;
    if (!is_look(reading, i)) return {};
    looks.push_back(i);
  }
  return looks;
}

// Whether a phrase goes on with the next one: ",", "and" or both are all that is between them.
bool leads_on(const PromptReading& reading, std::int32_t id) {
  if (id + 1 >= std::ssize(reading.parse.phrases)) return false;
  const auto begin = reading.phrase(id).tokens.end, end = reading.phrase(id + 1).tokens.begin;
  if (end <= begin || end > begin + 2) return false;
  for (auto i = begin; i < end; ++i)
    if (reading.text.plain[i].kind != Token::Kind::comma && !reading.is_word(i, "and")) return false;
  return true;
}

}  // namespace

std::optional<ThingPhrase> thing_of_next_noun(const PromptReading& reading, std::int32_t id) {
  const auto looks = looks_alone(reading, id);
  if (looks.empty()) return std::nullopt;
  std::int32_t next = id;
  do {
    if (!leads_on(reading, next)) return std::nullopt;
    ++next;
  } while (!looks_alone(reading, next).empty());
  const NounPhrase &said = reading.phrase(id), &named = reading.phrase(next);
  const ThingPhrase& whole = reading.thing(next);
  if (named.is_pronoun || whole.kind.length == 0 || !introduces(named) || whole.modifiers.empty()) return std::nullopt;
  ThingPhrase thing;
  thing.kind = whole.kind;
  thing.kind.plural = said.is_plural;
  thing.article = true;
  thing.count = std::max(1, static_cast<int>(said.count));
  thing.counted = said.determiner == Determiner::absent;
  for (auto i = said.tokens.begin; thing.counted && i < said.tokens.end; ++i)
    if (is_number(reading, i)) thing.count_tokens.push_back(i);
  for (const auto token : looks) {
    thing.modifiers.push_back(reading.word(token));
    thing.modifier_tokens.push_back({token, token + 1});
  }
  thing.name_tokens = said.tokens;
  thing.end = said.tokens.end;
  return thing;
}

}  // namespace roomgen::brief
