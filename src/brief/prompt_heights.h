#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// How high things hang: "a television at 1.8 m", "two shelves 1.5 m above the floor". Needs the things of the prompt;
/// what is said so tells no other place.
void read_heights(PromptReading& reading);

}  // namespace roomgen::brief
