#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Colours and stuffs that are said of no thing: "Milk, oatmeal, verdigris.", "raw brick, bare cedar", "persimmon
/// accents". They are the room's palette. Comes when all that names or describes things is heard.
void read_palette(PromptReading& reading);

}  // namespace roomgen::brief
