#pragma once

#include "dwelling_prompt.h"
#include "kind_mention.h"

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

/// A room, or the dwelling as a whole, where the prompt names it.
struct NamedRoom {
  std::size_t begin = 0;  ///< of its phrase: "two large bedrooms"
  std::size_t noun = 0, end = 0;
  std::string type;       ///< empty: the dwelling
  int count = 1;
  bool numbered = false;  ///< "two", "a"
  bool definite = false;  ///< "the bedroom"
  bool every = false;     ///< "both bedrooms", "each bedroom"
  bool en_suite = false;
  std::size_t ordinal = 0;  ///< "the second bedroom": 1
  std::vector<std::size_t> rooms;  ///< that it means (find_rooms())
};

/// In the order of the prompt.
std::vector<NamedRoom> find_room_names(const DwellingText& text);

/// A room that there shall be.
struct FoundRoom {
  std::string type;
  std::size_t owner = SaidRoom::none;  ///< index of the room from which it alone is entered
  std::size_t introduced = 0;          ///< the token behind its name
  std::string adjectives;              ///< "large "
};

/// Indices of those of a type.
std::vector<std::size_t> rooms_of_type(const std::vector<FoundRoom>& rooms,
                                       const std::string& type);

/// Where the dwelling as a whole is named ("a two-bedroom apartment"); null if nowhere.
const NamedRoom* whole_dwelling(const DwellingText& text, const std::vector<NamedRoom>& names);

/// The rooms that names introduce, and those that such a dwelling has besides; none if the prompt
/// is about no dwelling. Tells the names which rooms they mean.
std::vector<FoundRoom> find_rooms(const DwellingText& text, std::vector<NamedRoom>& names,
                                  std::vector<std::string>& notes);

/// Tokens of a prompt from one to before another.
struct Stretch {
  std::size_t begin = 0, end = 0;
};

/// What is said of each room: each clause goes to the room that it is said of, one that names none
/// to the room where its things usually stand.
std::vector<std::vector<Stretch>> share_clauses(const DwellingText& text,
                                                const std::vector<NamedRoom>& names,
                                                const std::vector<FoundRoom>& rooms,
                                                const RoomKinds& kinds,
                                                const KindTable& table);

}  // namespace roomgen::brief
