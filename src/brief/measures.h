#pragma once

#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::brief {

/// Takes the size of the room ("4 x 5 m", "12 by 15 feet", "20 square metres") out of the tokens
/// and into the brief; lengths that belong to a thing ("a 1.8 m desk") become single tokens.
void read_measures(std::vector<Token>& tokens, const std::vector<language::Token>& prompt,
                   const Vocabulary& words, const KindTable& table, Brief& brief);

/// Takes "for two", "for a family of four", "seats six" out of the tokens and into the brief.
void read_people(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                 Brief& brief);

}  // namespace roomgen::brief
