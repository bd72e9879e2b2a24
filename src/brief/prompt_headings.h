#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads headings that say where what follows is, up to the end of the sentence: "North wall: two
/// bookcases and a desk." Things of which another place was said keep that.
void read_headings(PromptReading& reading);

}  // namespace roomgen::brief
