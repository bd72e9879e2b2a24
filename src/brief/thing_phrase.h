#pragma once

#include <string>
#include <vector>

#include "kind_mention.h"
#include "language/parse.h"
#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::brief {

/// "two small white bedside tables": a noun phrase that may name a thing.
struct ThingPhrase {
  int count = 1;
  bool counted = false;   ///< an exact number was given
  double beyond = 0.0;    ///< that number, if it is more than is planned of one kind; else 0
  bool at_least = false, at_most = false;  ///< of the count
  int least = 0, most = 0;  ///< of a range; the count is between both. 0: none
  bool article = false;   ///< "a", a number, "some": introduces something
  bool definite = false;  ///< "the", "its": something known
  bool another = false;
  bool set = false;  ///< "set of", "pair of": they are alike
  KindMention kind;  ///< length 0: the thing is not known
  std::string noun;  ///< of an unknown thing
  std::vector<std::string> modifiers;
  std::vector<std::string> naming;  ///< of the modifiers the nouns that say what sort of thing it is
  std::vector<language::Run> modifier_tokens;  ///< one for each
  std::vector<std::uint32_t> count_tokens;
  language::Run name_tokens;
  std::string contents;  ///< "of honey"
  language::Run contents_tokens;
  std::vector<language::Measure> measures;
  std::vector<language::Run> measure_tokens;  ///< one for each
  int seats = 0;        ///< "six-seater"
  bool is_full_height = false;  ///< "floor to ceiling"
  std::size_t end = 0;  ///< the token behind its name: "stack of books" goes on behind the phrase
};

/// A prompt, and what is needed to name the things in it.
struct PromptText {
  const language::Parse& parse;
  const std::vector<Token>& plain;  ///< its tokens, one to one
  const Vocabulary& words;
  const KindTable& table;
};

/// What a noun phrase names, whether it is known or not. What is said of it elsewhere ("made of
/// oak", "is red") is among the modifiers.
ThingPhrase read_thing_phrase(const PromptText& text, std::size_t phrase);

/// Whether a noun that is no known kind may yet be that of a thing.
bool may_be_thing(const PromptText& text, const std::string& noun);

/// Whether what a list says without an article is rather stuff, or a colour: "milk and honey", "oak, linen
/// and brass".
bool may_be_stuff(const std::string& noun);

}  // namespace roomgen::brief
