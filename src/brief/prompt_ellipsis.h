#pragma once

#include <optional>

#include "prompt_reading.h"

namespace roomgen::brief {

/// "a black and a white chair", "two red and three blue cushions": what a noun phrase without a noun of its own means,
/// where it leads a list whose next member with a noun is introduced as it is; with its own number and looks.
std::optional<ThingPhrase> thing_of_next_noun(const PromptReading& reading, std::int32_t phrase);

}  // namespace roomgen::brief
