#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// How far apart things are: "a chair 0.5 m from the desk", "two beds 60 cm apart", "at least 1.5 m from every wall",
/// "within 1 m of the door", "2 m in front of the screen". Needs the things of the prompt, and comes before their places.
void read_distances(PromptReading& reading);

}  // namespace roomgen::brief
