#include "phrase_words.h"

#include <algorithm>

namespace roomgen::brief {

bool PhraseWords::is_number(std::size_t token) const {
  return text.plain[token].kind == Token::Kind::number || text.words.numbers.count(word(token));
}

bool PhraseWords::is_article(std::size_t token) const {
  return word(token) == "a" || word(token) == "an" || word(token) == "the";
}

bool PhraseWords::is_modifier(std::size_t token) const {
  for (auto i = said.modifiers.begin; i < said.modifiers.end; ++i)
    if (parse.modifiers[i].tokens.begin <= token && token < parse.modifiers[i].tokens.end) return true;
  return false;
}

bool PhraseWords::is_measured(std::size_t token, const ThingPhrase& thing) const {
  const bool is_name = thing.kind.length > 0 && token + 1 == thing.name_tokens.begin;  // "three light stands"
  const bool is_one = word(token) == "a" || word(token) == "an";                       // "a shelf" is one
  const bool is_compound = std::any_of(
      parse.modifiers.begin() + said.modifiers.begin, parse.modifiers.begin() + said.modifiers.end,
      [&](const auto& one) { return one.tokens.begin == token && one.tokens.size() == 2; });
  return is_number(token) && !is_name && !is_one && token < said.head &&
         (is_compound || text.words.measured.count(word(token + 1)) > 0);
}

std::string PhraseWords::in_singular(std::uint32_t first) const {
  const std::string head = parse.head_of(said);
  return first == said.head ? head : text_between(first, said.head - 1) + " " + head;
}

std::string PhraseWords::text_between(std::uint32_t first, std::uint32_t last) const {
  std::string joined = word(first);
  for (auto i = first + 1; i <= last; ++i) joined += " " + word(i);
  return joined;
}

}  // namespace roomgen::brief
