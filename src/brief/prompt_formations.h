#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// How several things stand to each other: "eight desks in two rows of four", "lockers in a line", "nine plinths in a 3
/// by 3 grid". Needs the things of the prompt.
void read_formations(PromptReading& reading);

}  // namespace roomgen::brief
