#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads what the noun phrases of a prompt name or exclude: reading.mentions says of each which
/// thing it means. Gives back those that are people, or what they do ("a reading corner"), which
/// read_occupants reads.
std::vector<std::int32_t> read_things(PromptReading& reading);

}  // namespace roomgen::brief
