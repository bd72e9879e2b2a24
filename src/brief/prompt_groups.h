#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// "a reading corner with two armchairs, a lamp and a side table", "in the play area a tent and a toy chest": what is
/// told of one area of the room stands together. Those of whose place nothing is said are near the largest of them.
void read_groups(PromptReading& reading);

}  // namespace roomgen::brief
