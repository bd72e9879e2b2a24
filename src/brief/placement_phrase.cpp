#include "placement_phrase.h"

#include <array>
#include <utility>

namespace roomgen::brief {

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

bool names_wall(std::span<const Token> tokens, std::size_t at) {
  return at < tokens.size() && (tokens[at].is_word("wall") || tokens[at].is_word("walls"));
}

// "of the room", "of the yoga room": how many tokens, or 0.
std::size_t of_the_room(std::span<const Token> tokens, std::size_t at) {
  if (at + 2 >= tokens.size() || !tokens[at].is_word("of") ||
      !(tokens[at + 1].is_word("the") || tokens[at + 1].is_word("this")))
    return 0;
  std::size_t end = at + 2;
  while (end < tokens.size() && tokens[end].kind == Token::Kind::room) ++end;
  if (end > at + 2) return end - at;
  const Token& noun = tokens[end];
  return noun.is_word("room") || noun.is_word("space") || noun.is_word("area") ? 3 : 0;
}

bool ends_phrase(std::span<const Token> tokens, std::size_t at, const Vocabulary& words) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::word || of_the_room(tokens, at) > 0)
    return true;
  const std::string& next = tokens[at].text;
  if (next == "a" || next == "an") return true;  // "at the front a lectern"
  return words.stops.count(next) && next != "of" && !words.room_parts.count(next) &&
         !words.shares.count(next) && !words.walls.count(next) && !names_side(tokens, at);
}

// The compass sides of the walls of a rectangle.
std::string side_of(int wall) {
  constexpr std::array<const char*, 4> sides = {"south", "east", "north", "west"};
  return sides[static_cast<std::size_t>(wall)];
}

bool are_opposite(int wall, int other) {
  return (wall + 2) % 4 == other;
}

// Of two walls that meet the corner between them, by north and south first; of one, "the far corner", either at its half.
std::string corner_region(int wall, int other) {
  if (wall >= 0 && other < 0) return side_of(wall) + "-half";
  if (wall < 0 || other < 0 || wall == other || are_opposite(wall, other)) return "";
  if (wall % 2 == 1) std::swap(wall, other);
  return side_of(wall) + "-" + side_of(other) + "-quarter";
}

}  // namespace

std::optional<PlacePhrase> read_place(std::span<const Token> tokens, std::size_t at,
                                      const Vocabulary& words) {
  PlacePhrase phrase;
  int wall_before = -1;
  bool in_middle = false;
  std::size_t i = at;
  // The phrase goes up to `end`, and "of the room" behind it.
  const auto found = [&](Place place, std::size_t end) {
    phrase.place = place;
    phrase.length = end + of_the_room(tokens, end) - at;
    return phrase;
  };
  const auto found_region = [&](const std::string& side, const std::string& share,
                                std::size_t end) {
    phrase.region = side + "-" + share;
    phrase.side = std::exchange(phrase.wall, -1);
    return found(Place::region, end);
  };
  for (std::size_t n = 0; n <= max_qualifiers && i < tokens.size(); ++n, ++i) {
    const Token& token = tokens[i];
    if (token.kind == Token::Kind::room) {
      phrase.length = i + 1 - at;
      return phrase;
    }
    if (token.kind != Token::Kind::word) return std::nullopt;
    if (i + 2 < tokens.size() && tokens[i + 1].is_word("to") && tokens[i + 2].text == token.text) return std::nullopt;  // "back to back"
    const auto wall = words.walls.find(token.text);
    if (const auto length = words.wall_lengths.find(token.text); length != words.wall_lengths.end() && names_wall(tokens, i + 1)) {
      phrase.length_of_wall = length->second;
      continue;
    }
    const auto share = longest(words.shares, tokens, i, 2);
    if (share && (phrase.wall >= 0 || in_middle))
      return found_region(in_middle ? "middle" : side_of(phrase.wall), *share.value,
                          i + share.length);
    // "the middle third"
    if (token.is_word("middle") && longest(words.shares, tokens, i + 1, 2)) {
      in_middle = true;
      continue;
    }
    if (const auto part = longest(words.room_parts, tokens, i, 2);
        part && wall == words.walls.end()) {
      const Place place = place_of(*part.value);
      if (place == Place::corner) phrase.region = corner_region(phrase.wall, wall_before);
      return found(place, i + part.length);
    }
    if (wall != words.walls.end()) {
      wall_before = phrase.wall;
      phrase.wall = wall->second;
      if (names_side(tokens, i + 1) && of_the_room(tokens, i + 2)) return found(Place::wall, i + 2);
      // "at the back": that half of the room
      if (ends_phrase(tokens, i + 1, words))
        return found_region(side_of(phrase.wall), "half", i + 1);
    }
    phrase.opposite = phrase.opposite || token.is_word("opposite") || token.is_word("opposing");
    // "each of the long walls"
    if (n > 0 && token.is_word("of") && (tokens[i - 1].is_word("each") || tokens[i - 1].is_word("both"))) continue;
    const bool stop = words.stops.count(token.text) > 0;
    const bool is_of_wall = names_wall(tokens, i + 1);  // "both side walls"
    if (stop && wall == words.walls.end() && !token.is_word("opposite") && !is_of_wall &&
        !is_article(token, words))
      return std::nullopt;
  }
  return std::nullopt;
}

std::string wall_named(const PlacePhrase& place) {
  if (place.wall >= 0) return "wall-" + std::to_string(place.wall);
  if (!place.length_of_wall.empty()) return place.length_of_wall + "-wall";
  return place.centered ? "long-wall" : "";
}

}  // namespace roomgen::brief
