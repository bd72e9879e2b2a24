#pragma once

#include <cstddef>
#include <span>

#include "prompt_words.h"
#include "tokens.h"

namespace roomgen::brief {

/// "forest green", "navy blue": does the word at `i` name the tone of the plain colour behind it? Stuffs, sizes and other
/// words that describe do not.
bool begins_tone(std::span<const Token> tokens, std::size_t i, const Vocabulary& words);

}  // namespace roomgen::brief
