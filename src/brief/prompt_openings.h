#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads the doors and windows that a prompt asks for; where things stand at one ("under the
/// window"), it is their place.
void read_openings(PromptReading& reading);

}  // namespace roomgen::brief
