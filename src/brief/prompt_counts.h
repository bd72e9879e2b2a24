#pragma once

#include <cstdint>

#include "prompt_reading.h"

namespace roomgen::brief {

/// So many of one thing are planned where as many people are told of.
inline constexpr double most_of_them = 40;

/// How many of a thing there are, where words around its phrase say so: "three rows of five seats", "four flatmates: each
/// has a bin".
void read_counts(PromptReading& reading, std::int32_t phrase, std::size_t mention);

}  // namespace roomgen::brief
