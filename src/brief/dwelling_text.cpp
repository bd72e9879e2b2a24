#include "dwelling_reading.h"
#include "room_type.h"

namespace roomgen::brief {

DwellingText::DwellingText(std::string_view text, const Vocabulary& vocabulary,
                           const DwellingKinds& dwelling_kinds, const RoomKinds& room_kinds,
                           const KindTable& table)
    : prompt(language::tokenize(text, max_tokens)),
      tokens(meaningful_tokens(prompt)),
      words(vocabulary),
      dwellings(dwelling_kinds),
      things(table),
      rooms(room_names(room_kinds)) {}

bool DwellingText::is_word(std::size_t i, std::string_view word) const {
  return i < tokens.size() && tokens[i].is_word(word);
}

bool DwellingText::ends_phrase(std::size_t i) const {
  return i >= tokens.size() || tokens[i].kind == Token::Kind::comma ||
         tokens[i].kind == Token::Kind::stop;
}

}  // namespace roomgen::brief
