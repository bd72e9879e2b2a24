#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads where the things of a prompt are said to be.
void read_places(PromptReading& reading);

}  // namespace roomgen::brief
