#pragma once

#include <string>

#include "phrase_text.h"
#include "words.h"

namespace roomgen::create {

/// A noun of a sentence.
struct PhraseNoun {
  enum class Role {
    none,      ///< nothing is known of it, or it is no noun
    modifier,  ///< says what the next noun is like: "a piano stool"
    part,
    object
  };
  Role role = Role::none;
  std::size_t length = 0;           ///< words
  std::string part;                 ///< its label
  const ShapeKind* kind = nullptr;  ///< of an object
};

/// What nouns are: things, or parts of the thing of which the sentence speaks. That is the head,
/// null before it is named; what parts it has decides.
class PhraseNouns {
 public:
  /// All must outlive it.
  PhraseNouns(const PhraseText& text, const Words& words, const ShapeKinds& kinds)
      : text_(text), words_(words), kinds_(kinds) {}

  /// "one can sit on it": no thing, although it is the name of a kind.
  bool is_pronoun(std::size_t at) const;
  /// A noun that another follows which it only describes: "an oven door", "a cube body".
  PhraseNoun compound(std::size_t at, const Description* head) const;
  /// Any other.
  PhraseNoun simple(std::size_t at, const Description* head) const;

  /// Does what follows a noun put it somewhere: "four chairs around it"?
  bool has_relation(std::size_t from) const;

 private:
  bool is_adjunct(std::size_t at, std::size_t kind_length, const Description* head) const;
  bool is_unknown_noun(std::size_t at, const Description* head) const;
  PhraseText::Run<std::string> part_at(std::size_t at, const Description* head) const;
  PhraseText::Run<std::string> part_of_head(std::size_t at, std::size_t kind_length,
                                            const Description* head) const;
  bool is_part(std::size_t at, std::size_t kind_length, const PhraseText::Run<std::string>& part,
               const Description* head) const;
  bool has_part(const Description* head, const std::string& label) const;

  const PhraseText& text_;
  const Words& words_;
  const ShapeKinds& kinds_;
};

}  // namespace roomgen::create
