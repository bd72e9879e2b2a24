#pragma once

#include <cstdint>

#include "prompt_reading.h"

namespace roomgen::brief {

/// Which of several things a noun phrase means, from 0: "the second bed", "the left armchair", "the last one",
/// "the other"; -1 if it does not say.
int which_of(const PromptReading& reading, std::int32_t phrase);

}  // namespace roomgen::brief
