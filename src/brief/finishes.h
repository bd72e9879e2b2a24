#pragma once

#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "scene/finish_words.h"
#include "tokens.h"

namespace roomgen::brief {

/// Reads what floor, walls and ceiling are covered with into Brief::materials ("dark oak floors", "walls
/// painted in sage", "a brick wall", "tiled"), and takes it out of the tokens, unless something is said
/// to be there ("a mirror on the white wall"). What is said first of a part counts.
void read_finishes(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                   const FinishWords& finishes, Brief& brief);

}  // namespace roomgen::brief
