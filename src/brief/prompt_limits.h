#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads what there shall be nothing but: "nothing else", "no other chairs", "no more than a laptop and a tray on the
/// desk", "nothing on the walls except a clock". Things were read before.
void read_limits(PromptReading& reading);

/// "Only", "each" and "every" of which nothing came were not understood.
void note_lost_limits(PromptReading& reading);

/// Whether a noun phrase says "no other", "nothing else": it denies none of the things that are named.
bool denies_others(const PromptReading& reading, const language::NounPhrase& phrase);

}  // namespace roomgen::brief
