#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// So many of one thing are planned where as many people are told of.
inline constexpr double most_of_them = 40;

/// How many of a thing there are, where words around its phrase say so: "three rows of five seats",
/// "four flatmates: each has a bin".
void read_counts(PromptReading& reading, std::int32_t phrase, std::size_t mention);

/// "a black and a white chair", "two red and three blue cushions": what a noun phrase without a
/// noun of its own means, where it leads a list whose next member with a noun is introduced as it
/// is; with its own number and looks.
std::optional<ThingPhrase> thing_of_next_noun(const PromptReading& reading, std::int32_t phrase);

/// "no rug", "nobody needs desks", "no pink": reads what shall not be there; whether the phrase
/// said so. What is denied a place ("not next to the sofa") is there.
bool read_exclusion(PromptReading& reading, std::int32_t phrase, const ThingPhrase& thing);

}  // namespace roomgen::brief
