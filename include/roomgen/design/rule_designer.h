#pragma once

#include <memory>

#include "roomgen/design/designer.h"

namespace roomgen {

/// Longest prompt that is read, in bytes.
inline constexpr std::size_t max_prompt_bytes = 100'000;

/// A designer that needs no language model: it reads English prompts with a small grammar, completes
/// them from the knowledge in data/rooms.json and places things by data/arrangements.json. What the
/// prompt says outranks what rooms usually hold.
///
/// plan() fails with invalid_input for an empty prompt and for a size outside 0.5 to 50 m, with limit
/// for a prompt beyond max_prompt_bytes. A prompt that names no room and no furniture gives a living
/// room and a note. place() keeps no state: equal requests give equal advice, and each refusal in the
/// request makes it give up more of its own wishes.
std::unique_ptr<Designer> make_rule_designer();

}  // namespace roomgen
