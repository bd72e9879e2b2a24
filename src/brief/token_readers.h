#pragma once

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

/// Takes the size of the room ("4 x 5 m", "12 by 15 feet", "20 square metres") out of the tokens
/// and into the brief; lengths that belong to a thing ("a 1.8 m desk") become single tokens.
void read_measures(std::vector<Token>& tokens, const std::vector<language::Token>& prompt,
                   const Vocabulary& words, const KindTable& table, Brief& brief);

/// Takes "for two", "for a family of four", "seats six" out of the tokens and into the brief.
void read_people(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                 Brief& brief);

/// Takes what is said of the room's shape ("an L-shaped living room", "the room is long and
/// narrow") out of the tokens and into the brief, and notes bays and alcoves. What is said of a
/// thing ("an L-shaped desk") stays.
void read_floor_shape(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                      const RoomKinds& kinds, Brief& brief);

/// Reads what floor, walls and ceiling are covered with into Brief::materials ("dark oak floors",
/// "walls painted in sage", "a brick wall", "tiled"), and takes it out of the tokens, unless
/// something is said to be there ("a mirror on the white wall"). What is said first of a part
/// counts.
void read_finishes(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                   const FinishWords& finishes, Brief& brief);

}  // namespace roomgen::brief
