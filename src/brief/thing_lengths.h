#pragma once

#include "phrase_words.h"

namespace roomgen::brief {

/// How long a thing is said to be: "a 2 m tall bookcase", "a table 1.6 m long", "the desk is 1.6 m wide". Needs its name.
void read_lengths(const PhraseWords& phrase, ThingPhrase& thing);

}  // namespace roomgen::brief
