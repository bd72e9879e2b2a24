#pragma once

#include <optional>

#include "inflection.h"
#include "token.h"

namespace roomgen::language {

/// What a word may be by itself, before anything around it is asked.
struct Candidates {
  bool is_noun = false;    ///< also of unknown words
  bool is_plural = false;  ///< of nouns
  bool is_adjective = false;
  bool is_adverb = false;
  bool is_small = false;    ///< stands in a list of small words
  bool is_content = false;  ///< a word that is not small
  std::optional<Verb> verb;
  double noun_uses = 0.0, verb_uses = 0.0, adjective_uses = 0.0;

  bool is_participle() const {
    return verb && (verb->form == VerbForm::past || verb->form == VerbForm::gerund);
  }
};

Candidates candidates(const Token& token);

}  // namespace roomgen::language
