#pragma once

#include <string_view>

#include "brief.h"
#include "room_kinds.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

/// Reads an English prompt: the kind of room, its size, the things named with numbers, looks and
/// places, what is forbidden. Never fails on what it does not understand: it leaves it out.
Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const KindTable& table);

}  // namespace roomgen::brief
