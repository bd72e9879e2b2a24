#include "placement_phrase.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_qualifiers = 5;

Place place_of(const std::string& part) {
  if (part == "window") return Place::window;
  if (part == "door") return Place::door;
  if (part == "corner") return Place::corner;
  if (part == "wall") return Place::wall;
  if (part == "middle") return Place::middle;
  if (part == "floor") return Place::floor;
  if (part == "ceiling") return Place::ceiling;
  return Place::room;
}

bool is_article(const Token& token, const Vocabulary& words) {
  return words.definite.count(token.text) || words.numbers.count(token.text) ||
         token.is_word("other") || token.is_word("very");
}

// "left side": a wall by another name.
bool names_side(std::span<const Token> tokens, std::size_t at) {
  return at < tokens.size() && (tokens[at].is_word("side") || tokens[at].is_word("hand"));
}

bool of_the_room(std::span<const Token> tokens, std::size_t at) {
  return at + 2 < tokens.size() && tokens[at].is_word("of") &&
         (tokens[at + 1].is_word("the") || tokens[at + 1].is_word("this")) &&
         (tokens[at + 2].kind == Token::Kind::room || tokens[at + 2].is_word("room") ||
          tokens[at + 2].is_word("space") || tokens[at + 2].is_word("area"));
}

}  // namespace

std::optional<PlacePhrase> read_place(std::span<const Token> tokens, std::size_t at,
                                      const Vocabulary& words) {
  PlacePhrase phrase;
  std::size_t i = at;
  for (std::size_t n = 0; n <= max_qualifiers && i < tokens.size(); ++n, ++i) {
    const Token& token = tokens[i];
    if (token.kind == Token::Kind::room) {
      phrase.length = i + 1 - at;
      return phrase;
    }
    if (token.kind != Token::Kind::word) return std::nullopt;
    const auto wall = words.walls.find(token.text);
    if (const auto part = longest(words.room_parts, tokens, i, 2);
        part && wall == words.walls.end()) {
      phrase.place = place_of(*part.value);
      i += part.length;
      if (of_the_room(tokens, i)) i += 3;
      phrase.length = i - at;
      return phrase;
    }
    if (wall != words.walls.end()) {
      phrase.wall = wall->second;
      if (names_side(tokens, i + 1) && of_the_room(tokens, i + 2)) {
        phrase.place = Place::wall;
        phrase.length = i + 5 - at;
        return phrase;
      }
    }
    phrase.opposite = phrase.opposite || token.is_word("opposite") || token.is_word("opposing");
    const bool stop = words.stops.count(token.text) > 0;
    if (stop && wall == words.walls.end() && !token.is_word("opposite") &&
        !is_article(token, words))
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace roomgen::design
