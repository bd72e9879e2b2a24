#pragma once

#include <cstdint>
#include <optional>

#include "prompt_reading.h"

namespace roomgen::brief {

/// "at opposite ends of the room", "along both long walls": whether an attachment names places that there are two of.
std::optional<Discourse::Both> two_places(const PromptReading& reading, const language::Attachment& attachment,
                                          const SaidPlacement& said);

/// "on the left and right", "on the left and right walls", which the parse takes for two places: the words from the first on.
std::optional<language::Run> left_and_right(const PromptReading& reading, const language::Attachment& attachment);

/// "the ends of the room": whether a noun phrase names a part of the room.
bool is_of_room(const PromptReading& reading, std::int32_t part);

}  // namespace roomgen::brief
