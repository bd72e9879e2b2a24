#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads what the noun phrases of a prompt name or exclude: reading.mentions says of each which
/// thing it means.
void read_things(PromptReading& reading);

}  // namespace roomgen::brief
