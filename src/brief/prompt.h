#pragma once

#include <string_view>
#include <vector>

#include "brief.h"
#include "language/token.h"
#include "room_kinds.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// Reads an English prompt by rules: the kind of room, its size, the things named with numbers, looks
/// and places, what is forbidden. Never fails on what it does not understand: it leaves it out. Nothing
/// is concluded from it yet.
Brief read_words(std::string_view prompt, const RoomKinds& kinds, const KindTable& table);
/// The same of its words, or of some of them.
Brief read_words(std::vector<language::Token> prompt, const RoomKinds& kinds,
                 const KindTable& table);

/// Draws from what was read, by rules or by a model, what a plan needs: numbers of what is uncounted,
/// what stands on what, the kind of a room that has no name.
void conclude(Brief& brief, const RoomKinds& kinds, const KindTable& table);

/// Both.
Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const KindTable& table);

}  // namespace roomgen::brief
