#include <algorithm>

#include "dwelling_reading.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t longest_room_name = 3;
constexpr int most_of_a_kind = 8;

struct RoomName {
  std::string type;
  std::size_t length = 0;  ///< 0: there is none
};

// In the singular or plural.
RoomName room_at(const DwellingText& text, std::size_t i) {
  RoomName best;
  std::string phrase;
  for (std::size_t n = 0; n < longest_room_name && i + n < text.tokens.size(); ++n) {
    if (text.tokens[i + n].kind != Token::Kind::word) break;
    phrase += (n ? " " : "") + text.tokens[i + n].text;
    for (const auto& name : singulars(phrase)) {
      const auto found = text.rooms.find(name);
      if (found == text.rooms.end() || text.dwellings.no_rooms.count(name) ||
          !text.dwellings.rooms.count(found->second))
        continue;
      best = {found->second, n + 1};
      break;
    }
  }
  if (mention_at(text.things, text.tokens, i).length > best.length) best.length = 0;
  return best;
}

// Backwards from the noun: its adjectives, its number or article.
void read_determiner(const DwellingText& text, std::size_t least, NamedRoom& named) {
  const Vocabulary& words = text.words;
  std::size_t i = named.noun;
  while (i > least && named.noun - i < longest_phrase) {
    const Token& token = text.tokens[i - 1];
    if (token.is_word("both") || token.is_word("each") || token.is_word("every") ||
        token.is_word("all"))
      named.every = named.definite = true;
    else if (words.definite.count(token.text))
      named.definite = true;
    else if (token.kind == Token::Kind::number && token.value >= 1 && token.value <= most_of_a_kind)
      named.count = static_cast<int>(token.value), named.numbered = true;
    else if (const auto number = words.numbers.find(token.text);
             token.kind == Token::Kind::word && number != words.numbers.end() && number->second > 0)
      named.count = std::min(number->second, most_of_a_kind), named.numbered = true;
    else if (token.kind != Token::Kind::word || words.stops.count(token.text) ||
             words.negations.count(token.text))
      break;
    else if (token.is_word("second") || token.is_word("other"))
      named.ordinal = 1;
    else if (token.is_word("third"))
      named.ordinal = 2;
    --i;
    if (named.numbered || (named.definite && !named.every)) break;
  }
  named.begin = i;
}

}  // namespace

std::vector<NamedRoom> find_room_names(const DwellingText& text) {
  std::vector<NamedRoom> all;
  for (std::size_t i = 0; i < text.tokens.size(); ++i) {
    if (text.tokens[i].kind != Token::Kind::word) continue;
    RoomName name = room_at(text, i);
    const bool dwelling = name.length == 0 &&
                          text.dwellings.dwellings.count(text.tokens[i].text) &&
                          mention_at(text.things, text.tokens, i).length == 0;
    if (dwelling) name = {"", 1};
    if (name.length == 0 || is_within_name(text.things, text.tokens, i)) continue;
    NamedRoom named;
    named.type = name.type;
    named.noun = i;
    named.end = i + name.length;
    named.en_suite = text.is_word(i, "ensuite") || text.is_word(i + 1, "suite");
    // "en suite bathroom" is one room.
    const RoomName again = room_at(text, named.end);
    if (again.length > 0 && again.type == named.type) named.end += again.length;
    read_determiner(text, all.empty() ? 0 : all.back().end, named);
    i = named.end - 1;
    all.push_back(named);
  }
  return all;
}

}  // namespace roomgen::brief
