#pragma once

#include "language/token.h"

namespace roomgen::language {

/// Whether a token says nothing by itself: a mark, or a word of the closed classes (articles,
/// pronouns, prepositions, conjunctions, auxiliaries, adverbs of degree) of data/language/words.json.
/// Numbers, quantities and negations are none.
bool is_function_word(const Token& token);

}  // namespace roomgen::language
