#pragma once

#include "phrase_words.h"

namespace roomgen::brief {

/// How many of a thing a noun phrase speaks of, and whether it introduces them. Needs its name.
void read_number(const PhraseWords& phrase, ThingPhrase& thing);

}  // namespace roomgen::brief
