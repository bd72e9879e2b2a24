#pragma once

#include <cstddef>

#include "prompt_reading.h"

namespace roomgen::brief {

/// "side by side", "back to back", "facing each other" of things: the last two of them, or the halves of several. Of
/// several that stand next to each other a row is made.
void relate_mutually(PromptReading& reading, const Indices& things, const Placement& placement);

/// The same said behind a list or a noun, at a token: "a desk and a shelf side by side". `heard`: the words that say so.
void relate_listed(PromptReading& reading, std::size_t token, const Placement& placement, std::size_t heard);

}  // namespace roomgen::brief
