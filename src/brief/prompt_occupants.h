#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads the people or the activities that a noun phrase names: they bring what they need, and the
/// phrase stands for the first of it.
void read_occupants(PromptReading& reading, std::int32_t phrase);

/// Reads the activities that no noun phrase names: "where we knit", "to read".
void read_activities(PromptReading& reading);

/// "my 15 yr old son": the number is an age.
bool tells_age(const PromptReading& reading, const language::NounPhrase& said);

}  // namespace roomgen::brief
