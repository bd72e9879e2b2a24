#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dwelling_kinds.h"
#include "kind_mention.h"
#include "room_kinds.h"

namespace roomgen::brief {

/// A prompt for several rooms as words, and what the words are known to name.
struct DwellingText {
  /// The vocabulary and the kinds of dwellings must outlive it.
  DwellingText(std::string_view prompt, const Vocabulary& vocabulary,
               const DwellingKinds& dwelling_kinds, const RoomKinds& room_kinds,
               const KindTable& table);

  bool is_word(std::size_t i, std::string_view word) const;
  /// Is there a mark, or the end?
  bool ends_phrase(std::size_t i) const;

  const std::vector<language::Token> prompt;
  const std::vector<Token> tokens;
  const Vocabulary& words;
  const DwellingKinds& dwellings;
  const KindTable& things;
  const std::map<std::string, std::string, std::less<>> rooms;  ///< kinds, by all their names
};

/// Words before the noun of a room.
inline constexpr std::size_t longest_phrase = 6;

}  // namespace roomgen::brief
