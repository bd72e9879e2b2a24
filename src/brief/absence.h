#pragma once

#include <optional>
#include <span>
#include <vector>

#include "kind_mention.h"
#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::design {

/// "no TV, desk or rug", "without windows"
struct Absence {
  std::vector<KindMention> kinds;
  bool windows = false;
  std::size_t end = 0;  ///< the token behind it
};

/// Bare nouns after a negation belong to it; an article or a number begins something new.
std::optional<Absence> read_absence(std::span<const Token> tokens, std::size_t at,
                                    const Vocabulary& words, const KindTable& table);

/// The token behind "nothing else", "no other …" or the "only" of "with only"; `at` if none is
/// there.
std::size_t read_only(std::span<const Token> tokens, std::size_t at, const Vocabulary& words);

}  // namespace roomgen::design
