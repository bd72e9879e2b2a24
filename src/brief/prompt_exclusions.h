#pragma once

#include <cstdint>

#include "prompt_reading.h"

namespace roomgen::brief {

/// "no rug", "nobody needs desks", "no pink": reads what shall not be there; whether the phrase said so. What is denied a
/// place ("not next to the sofa") is there.
bool read_exclusion(PromptReading& reading, std::int32_t phrase, const ThingPhrase& thing);

}  // namespace roomgen::brief
