#pragma once

#include "phrase_words.h"

namespace roomgen::brief {

/// What thing a noun phrase names, known or not, and which of its words say so.
void read_name(const PhraseWords& phrase, ThingPhrase& thing);

}  // namespace roomgen::brief
