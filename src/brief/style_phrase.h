#pragma once

#include <optional>
#include <span>
#include <string>

#include "brief.h"
#include "room_kinds.h"
#include "tokens.h"

namespace roomgen::brief {

/// Words of style or mood: "rustic", "organic modern", "little".
struct StylePhrase {
  std::string name;        ///< as they are written
  std::size_t length = 0;  ///< tokens
  bool is_look = false;    ///< things look so; "little" says only how large a room is
};

/// The longest that begins at a token: a name of data/styles.json, or a word of data/rooms.json.
std::optional<StylePhrase> style_at(std::span<const Token> tokens, std::size_t at, const RoomKinds& kinds);

/// Adds it to what was heard, and to the styles of the room unless it is one of them already.
void hear_style(Brief& brief, const StylePhrase& style, const language::Run& tokens);

}  // namespace roomgen::brief
