#pragma once

#include <string>
#include <vector>

#include "roomgen/create/maker.h"
#include "words.h"

namespace roomgen::create {

/// Longest description that is read, bytes.
inline constexpr std::size_t longest_phrase = 2000;

/// Is it a thing that stands indoors, and one that can be? `objects` is what was read of the prompt.
Verdict classify_phrase(const std::string& prompt, const std::vector<Description>& objects,
                        const Words& words);

}  // namespace roomgen::create
