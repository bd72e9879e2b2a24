#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// "Five tables, three along the left wall and two along the right", "two of the chairs face the window": those of
/// several things of which something of their own is said become mentions of their own, and what the phrases mean.
void read_partitions(PromptReading& reading);

}  // namespace roomgen::brief
