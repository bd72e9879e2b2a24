#include "measures.h"

#include <algorithm>
#include <optional>

#include "opening_phrase.h"

namespace roomgen::design {

namespace {

constexpr double metres_up_to = 30.0;  ///< bare numbers up to this are metres
constexpr std::size_t ahead = 4;       ///< words between a length and its thing

struct Length {
  double value = 0.0;
  double unit = 0.0;       ///< 0: not given
  std::size_t length = 0;  ///< tokens
};

std::optional<Length> length_at(const std::vector<Token>& tokens, std::size_t at,
                                const Vocabulary& words) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::number) return std::nullopt;
  Length length{tokens[at].value, 0.0, 1};
  if (const auto unit = longest(words.units, tokens, at + 1, 1)) {
    length.unit = *unit.value;
    length.length = 2;
    // 5 feet 10 inches, 12' 6
    if (length.unit > 0.3 && length.unit < 0.31 && at + 3 < tokens.size() &&
        tokens[at + 2].kind == Token::Kind::number && tokens[at + 3].text.starts_with("inch")) {
      length.value += tokens[at + 2].value / 12.0;
      length.length = 4;
    }
  }
  return length;
}

bool joins(const Token& token) {
  return token.is_word("x") || token.is_word("by") || token.is_word("times");
}

// The measured is a thing rather than the room when one is named right after.
bool thing_follows(const std::vector<Token>& tokens, std::size_t at, const KindTable& table,
                   const Vocabulary& words) {
  for (std::size_t i = at; i < tokens.size() && i < at + ahead; ++i) {
    if (tokens[i].kind != Token::Kind::word) return false;
    if (mention_at(table, tokens, i).length > 0 && !words.materials.count(tokens[i].text)) return true;
    if (const auto& kinds = OpeningKinds::built_in();
        kinds && opening_name_at(tokens, i, *kinds) > 0)
      return true;
    if (words.stops.count(tokens[i].text) || words.room_words.count(tokens[i].text)) return false;
  }
  return false;
}

void replace(std::vector<Token>& tokens, std::size_t at, std::size_t count,
             const std::vector<Token>& with) {
  const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(at);
  tokens.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(at), with.begin(), with.end());
}

bool sensible(double side) {
  return side >= least_room_side && side <= greatest_room_side;
}

void set_size(const Vec2& size, Brief& brief) {
  if (!sensible(size.x()) || !sensible(size.y())) {
    brief.notes.push_back("the size in the prompt is beyond 0.5 to 50 m and was not used");
    return;
  }
  if (!brief.size) brief.size = size;
}

// "4 x 5 m": both in the unit of the second, which may be metres without saying so.
bool read_sides(std::vector<Token>& tokens, std::size_t at, const Vocabulary& words,
                const KindTable& table, Brief& brief) {
  const auto a = length_at(tokens, at, words);
  if (!a || at + a->length >= tokens.size() || !joins(tokens[at + a->length])) return false;
  const auto b = length_at(tokens, at + a->length + 1, words);
  if (!b) return false;
  std::size_t count = a->length + 1 + b->length;
  const double unit_b = b->unit > 0 ? b->unit : a->unit > 0 ? a->unit : 1.0;
  const double unit_a = a->unit > 0 ? a->unit : unit_b;
  if (b->unit == 0 && std::max(a->value, b->value) > metres_up_to) return false;
  const Vec2 size(a->value * unit_a, b->value * unit_b);
  if (thing_follows(tokens, at + count, table, words)) {
    replace(tokens, at, count,
            {{Token::Kind::length, "length", size.x()}, {Token::Kind::length, "depth", size.y()}});
    return true;
  }
  // A third side is the height of the room.
  if (at + count < tokens.size() && joins(tokens[at + count]))
    if (const auto c = length_at(tokens, at + count + 1, words)) count += 1 + c->length;
  set_size(size, brief);
  replace(tokens, at, count, {});
  return true;
}

bool read_area(std::vector<Token>& tokens, std::size_t at, const Vocabulary& words, Brief& brief) {
  if (tokens[at].kind != Token::Kind::number) return false;
  const auto unit = longest(words.areas, tokens, at + 1, 2);
  if (!unit) return false;
  const double area = tokens[at].value * *unit.value;
  if (area >= least_room_side * least_room_side && area <= greatest_room_side * greatest_room_side)
    brief.area = area;
  else
    brief.notes.push_back(
        "the floor area in the prompt is beyond 0.25 to 2500 m2 and was not used");
  replace(tokens, at, unit.length + 1, {});
  return true;
}

bool read_length(std::vector<Token>& tokens, std::size_t at, const Vocabulary& words) {
  const auto length = length_at(tokens, at, words);
  if (!length || length->unit == 0) return false;
  replace(tokens, at, length->length,
          {{Token::Kind::length, "length", length->value * length->unit}});
  return true;
}

std::optional<int> number_at(const std::vector<Token>& tokens, std::size_t at,
                             const Vocabulary& words) {
  if (at >= tokens.size()) return std::nullopt;
  if (tokens[at].kind == Token::Kind::number) {
    const double value = tokens[at].value;
    return value >= 1 && value <= 200 ? std::optional<int>(static_cast<int>(value)) : std::nullopt;
  }
  const auto found = words.numbers.find(tokens[at].text);
  if (found == words.numbers.end()) return std::nullopt;
  return found->second;
}

// After "for": how many tokens speak of people, and how many people they are.
struct People {
  int count = 0;
  std::size_t length = 0;
};

People people_at(const std::vector<Token>& tokens, std::size_t at, const Vocabulary& words,
                 const KindTable& table) {
  std::size_t i = at;
  while (i < tokens.size() && (tokens[i].is_word("a") || tokens[i].is_word("the") ||
                               tokens[i].is_word("my") || tokens[i].is_word("young")))
    ++i;
  if (i < tokens.size() && tokens[i].is_word("family") && i + 2 < tokens.size() &&
      tokens[i + 1].is_word("of"))
    if (const auto count = number_at(tokens, i + 2, words)) return {*count, i + 3 - at};
  if (const auto group = longest(words.people, tokens, i, 2))
    return {*group.value, i + group.length - at};
  const auto count = number_at(tokens, i, words);
  if (!count) return {};
  std::size_t end = i + 1;
  if (end < tokens.size() && tokens[end].kind == Token::Kind::word) {
    if (words.people_words.count(tokens[end].text)) return {*count, end + 1 - at};
    // "for two chairs" speaks of chairs.
    if (!words.stops.count(tokens[end].text) && thing_follows(tokens, end, table, words)) return {};
    if (!words.stops.count(tokens[end].text)) return {};
  }
  return i == at ? People{*count, end - at} : People{};
}

}  // namespace

void read_measures(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                   Brief& brief) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::number) continue;
    if (read_area(tokens, i, words, brief) || read_sides(tokens, i, words, table, brief))
      --i;
    else
      read_length(tokens, i, words);
  }
}

void read_people(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                 Brief& brief) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (!tokens[i].is_word("for") && !tokens[i].is_word("seats") && !tokens[i].is_word("seating") &&
        !tokens[i].is_word("sleeps"))
      continue;
    const People people = people_at(tokens, i + 1, words, table);
    if (people.length == 0) continue;
    if (brief.people == 0) brief.people = std::min(people.count, 40);
    replace(tokens, i, people.length + 1, {});
    if (i > 0) --i;
  }
}

}  // namespace roomgen::design
