#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "measure.h"
#include "token.h"

namespace roomgen::language {

/// A run of a flat vector: the first, and one past the last.
struct Run {
  std::uint32_t begin = 0, end = 0;

  std::uint32_t size() const { return end - begin; }
  bool empty() const { return begin == end; }
  friend bool operator==(const Run&, const Run&) = default;
};

inline constexpr std::int32_t none = -1;

enum class Determiner : std::uint8_t {
  absent,
  indefinite,  ///< a, such a
  definite,    ///< the, this, those
  possessive,  ///< my, its
  each,        ///< each, every
  all,
  both,
  no,  ///< no, neither
  any,
  another
};

/// What a noun is like.
struct Modifier {
  enum class Kind : std::uint8_t {
    adjective,
    noun,        ///< "coffee" of a coffee table
    participle,  ///< "framed"
    owner        ///< "cat's"
  };
  Kind kind = Kind::adjective;
  bool is_denied = false;  ///< "not red"
  Run tokens;              ///< several when joined by hyphens: "L-shaped"
};

/// "two red chairs": a thing, a person, a measure of stuff; or a word that stands for one.
struct NounPhrase {
  Run tokens;
  std::uint32_t head = 0;  ///< token
  Determiner determiner = Determiner::absent;
  double count = 0.0;     ///< 0: not said; articles say 1, "both" 2
  bool is_vague = false;  ///< "some", "lots of"
  bool is_plural = false;
  bool is_denied = false;       ///< "no rug", "avoid glass tables"
  bool is_pronoun = false;      ///< it, them, the other, each: stands for something said before
  Run modifiers;                ///< of Parse::modifiers
  std::int32_t measure = none;  ///< of Parse::measures
  std::int32_t list = none;     ///< of Parse::lists
};

/// "A, B and C".
struct List {
  Run members;             ///< of Parse::members, which are noun phrases
  bool is_choice = false;  ///< joined by or
};

/// What is done, or what something is like.
struct VerbPhrase {
  enum class Kind : std::uint8_t {
    imperative,   ///< place, put, add: the object is to be
    existential,  ///< there is
    finite,       ///< stands, has, should face
    participle,   ///< "facing the window", "made of oak": behind its noun
    relative      ///< "that holds coats"
  };
  Kind kind = Kind::finite;
  Run tokens;
  std::string base;  ///< of the main verb
  bool is_denied = false;
  bool is_passive = false;
  std::int32_t subject = none;  ///< noun phrase; with its list
  std::int32_t object = none;   ///< noun phrase; with its list
  Run complement;               ///< of Parse::modifiers: "the walls are white"
};

/// "on the desk": a preposition, or a verb between two things ("holds"), from what to what.
struct Attachment {
  std::int32_t from = none;  ///< noun phrase
  bool is_of_list = false;   ///< from all members of the list that `from` is in: "A, B and C on X"
  std::int32_t to = none;    ///< noun phrase
  std::int32_t verb = none;  ///< verb phrase, of verbs between two things and of what verbs govern
  Run tokens;                ///< of the preposition or the verb
  std::string relation;      ///< in lower case; of verbs the base form
  bool is_verb = false;
  bool is_denied = false;  ///< "not against the wall"
};

/// What the words of a text are to each other. A value: flat vectors that refer to each other by
/// index, in the order of the text; every part knows its tokens, and these their bytes.
struct Parse {
  std::vector<Token> tokens;
  std::vector<NounPhrase> phrases;
  std::vector<Modifier> modifiers;
  std::vector<Measure> measures;
  std::vector<std::uint32_t> members;
  std::vector<List> lists;
  std::vector<VerbPhrase> verbs;
  std::vector<Attachment> attachments;
  std::vector<Run> sentences;  ///< of tokens

  Span span_of(const Run& tokens) const;
  /// Of a phrase in the singular: "chair".
  std::string head_of(const NounPhrase& phrase) const;
  /// As written, hyphens kept, in lower case: "l-shaped".
  std::string text_of(const Modifier& modifier) const;
  /// The phrase alone, or all members of its list.
  std::vector<std::uint32_t> with_list(std::uint32_t phrase) const;
};

/// Whether two words, in the singular with a space between them, are the name of something where the
/// text comes from: of furniture "drying rack" is, whatever else drying may be.
using IsName = std::function<bool(std::string_view)>;

/// Parses a text of any length and any bytes; of more than max_tokens tokens only the first count.
/// Deterministic, in time linear in the length of the text.
Parse parse(std::string_view text, const IsName& is_name = {});
Parse parse(std::vector<Token> tokens, const IsName& is_name = {});

}  // namespace roomgen::language
