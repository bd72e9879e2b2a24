#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kind_mention.h"
#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::design {

/// "two small white bedside tables"
struct NounPhrase {
  std::size_t begin = 0, end = 0;
  int count = 1;
  bool counted = false;   ///< an exact number was given
  bool article = false;   ///< "a", a number, "some": introduces something
  bool definite = false;  ///< "the", "its": something known
  bool another = false;
  bool set = false;  ///< "set of", "pair of": they are alike
  KindMention kind;    ///< length 0: the thing is not known
  std::string noun;  ///< of an unknown thing
  std::vector<std::string> modifiers;
  std::string contents;  ///< "of honey"
  std::vector<Token> lengths;
  int seats = 0;  ///< "six-seater"
};

/// Reads a noun phrase that starts at `at`; nothing if there is none. `may_be_unknown` admits nouns
/// that are no category, when an article or a number stands before them.
std::optional<NounPhrase> read_noun_phrase(std::span<const Token> tokens, std::size_t at,
                                           const Vocabulary& words, const KindTable& table,
                                           bool may_be_unknown);

}  // namespace roomgen::design
