#pragma once

#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "room_kinds.h"
#include "tokens.h"

namespace roomgen::brief {

/// Of a plan that names no room.
inline constexpr const char* default_room_type = "living room";

/// Finds what room the prompt speaks of: a known kind by any of its names, rather one that is the
/// head of its noun phrase ("a theatre poster in the bedroom"), or else words such as "boat house"
/// or "a brewery with …". Every name of the room, and of others that are heads, becomes one token;
/// the words of style before it, and before "style" and its like, go into the brief.
void read_room_type(std::vector<Token>& tokens, const language::Parse& parse,
                    const Vocabulary& words, const KindTable& table, const RoomKinds& kinds,
                    Brief& brief);

/// The known kind of room that usually holds most of what is mentioned, and what it is known by;
/// empty if nothing tells.
std::string guess_room_type(const Brief& brief, const RoomKinds& kinds, const KindTable& table);

}  // namespace roomgen::brief
