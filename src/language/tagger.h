#pragma once

#include <string>
#include <vector>

#include "inflection.h"
#include "parse.h"

namespace roomgen::language {

/// What a piece of a sentence does in it.
enum class Tag : std::uint8_t {
  stop,
  comma,  ///< and brackets
  conjunction,
  preposition,
  determiner,
  number,
  measure,
  pronoun,
  owner,  ///< "cat's"
  noun,
  adjective,
  participle,  ///< before its noun, or behind it with what belongs to it
  verb,
  be,
  auxiliary,
  negation,
  relative,
  there,  ///< of "there is"
  adverb,
  subordinator,
  to  ///< of an infinitive
};

/// One word, or several that are one: "in front of", "twenty-one", "L-shaped".
struct Piece {
  Tag tag = Tag::noun;
  Run tokens;
  std::string base;  ///< of verbs; of prepositions their words
  VerbForm form = VerbForm::base;
  bool is_denied = false;  ///< "don't", "isn't"
  bool is_plural = false;  ///< of nouns
  bool is_clause = false;  ///< of participles: behind its noun
  double value = 0.0;      ///< of numbers
  Measure measure;
};

/// The longest noun phrase, in pieces: what is longer is none.
inline constexpr std::size_t longest_phrase = 40;

/// Cuts a text into pieces and says what each does, from left to right: small words by their lists,
/// others by the lexicon and by what stands around them. Quotes and symbols are left out.
std::vector<Piece> tag(const std::vector<Token>& tokens, const IsName& is_name = {});

}  // namespace roomgen::language
