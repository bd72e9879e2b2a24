#pragma once

#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "room_kinds.h"
#include "tokens.h"

namespace roomgen::brief {

/// Takes what is said of the room's shape ("an L-shaped living room", "the room is long and
/// narrow") out of the tokens and into the brief, and notes bays and alcoves. What is said of a
/// thing ("an L-shaped desk") stays.
void read_floor_shape(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                      const RoomKinds& kinds, Brief& brief);

}  // namespace roomgen::brief
