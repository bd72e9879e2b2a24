#pragma once

#include <string>

#include "thing_phrase.h"

namespace roomgen::brief {

/// A noun phrase of a prompt and its words, for the readers of a thing's name, number, looks and lengths.
class PhraseWords {
 public:
  PhraseWords(const PromptText& prompt, std::size_t which)
      : text(prompt), parse(prompt.parse), number(static_cast<std::int32_t>(which)), said(parse.phrases[which]) {}

  const std::string& word(std::size_t token) const { return text.plain[token].text; }
  bool is_number(std::size_t token) const;
  bool is_article(std::size_t token) const;
  /// Is a word before the noun rather than the noun itself?
  bool is_modifier(std::size_t token) const;
  /// "three-drawer", "six seater" of the thing: no count of things.
  bool is_measured(std::size_t token, const ThingPhrase& thing) const;
  /// The words from one up to the noun, the noun in the singular.
  std::string in_singular(std::uint32_t first) const;
  std::string text_between(std::uint32_t first, std::uint32_t last) const;

  const PromptText& text;
  const language::Parse& parse;
  const std::int32_t number;  ///< of the phrase
  const language::NounPhrase& said;
};

inline void add_modifier(ThingPhrase& thing, std::string word, const language::Run& tokens) {
  thing.modifiers.push_back(std::move(word));
  thing.modifier_tokens.push_back(tokens);
}

}  // namespace roomgen::brief
