#pragma once

#include <span>
#include <string>
#include <vector>

#include "kinds/noun_kind.h"
#include "roomgen/kinds/kind_table.h"
#include "tokens.h"

namespace roomgen::brief {

/// A name of a kind in a text.
struct KindMention {
  const Kind* category = nullptr;  ///< as plans know it
  std::size_t length = 0;  ///< tokens; 0 if there is none
  bool plural = false;
  std::string name;  ///< in the singular: "bedside table"
  NounBasis basis = NounBasis::name;  ///< what makes the name mean the kind
  std::string misspelt = {};          ///< as it was written, if that was wrong: "bokshelf"

  /// No kind is called so: WordNet knows what it is.
  bool is_inferred() const {
    return basis == NounBasis::synonym || basis == NounBasis::hyponym || is_stand_in();
  }
  bool is_stand_in() const { return basis == NounBasis::stand_in; }
};

/// The longest name of a kind that starts at `at`, in the singular or the plural.
KindMention mention_at(const KindTable& kinds, std::span<const Token> tokens, std::size_t at);

/// Whether a word belongs to the name of a kind that begins before it: "kitchen" of a play kitchen.
bool is_within_name(const KindTable& kinds, std::span<const Token> tokens, std::size_t at);

/// What a word may be in the singular; the word itself first.
std::vector<std::string> singulars(const std::string& word);

}  // namespace roomgen::brief
