#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Gives each of several things its own where as many colours are said of them: "four bins (red, blue, green, yellow)", or they are
/// said to alternate. Of two other things both may be of both colours.
void share_colours(PromptReading& reading);

}  // namespace roomgen::brief
