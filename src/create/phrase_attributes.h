#pragma once

#include "attributes.h"
#include "phrase_text.h"
#include "words.h"

namespace roomgen::create {

/// Adjectives that were read.
struct ReadAttribute {
  std::size_t length = 0;  ///< words; 0: none is there
  bool of_form = false;    ///< they say how something is shaped or made
};

/// Adds what the words there say of the noun to come: a number, how strongly, a style, a form, a
/// material, a size, a direction or a colour.
ReadAttribute read_attribute(const PhraseText& text, std::size_t at, const Words& words,
                             Attributes& to);

/// Are the words a thing, although the first of them may say what one is like: "wine rack", and "a
/// ladder" where no other thing was named?
bool names_thing(const PhraseText& text, std::size_t at, const Words& words, bool first);

}  // namespace roomgen::create
