#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// What is added to a thing behind it, between marks: "racks, 2 m tall, anthracite", "chairs: ten", "a mat (blue)",
/// "cabinets, four in number". Needs the things of the prompt; what is no addition as a whole is left.
void read_additions(PromptReading& reading);

}  // namespace roomgen::brief
