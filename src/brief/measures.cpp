#include <algorithm>
#include <optional>

#include "opening_phrase.h"
#include "token_readers.h"

namespace roomgen::brief {

namespace {

constexpr double metres_up_to = 30.0;  ///< bare numbers up to this are metres
constexpr double least_ceiling = 2.0, greatest_ceiling = 12.0;  ///< metres above the floor
constexpr std::size_t ahead = 4;       ///< words between a length and its thing

// The measured is a thing rather than the room when one is named right after.
bool thing_follows(const std::vector<Token>& tokens, std::size_t at, const KindTable& table,
                   const Vocabulary& words) {
  for (std::size_t i = at; i < tokens.size() && i < at + ahead; ++i) {
    if (tokens[i].kind != Token::Kind::word) return false;
    if (mention_at(table, tokens, i).length > 0 && !words.materials.count(tokens[i].text))
      return true;
    if (const auto& kinds = OpeningKinds::built_in();
        kinds && opening_name_at(tokens, i, *kinds) > 0)
      return true;
    if (words.stops.count(tokens[i].text) || words.room_words.count(tokens[i].text)) return false;
  }
  return false;
}

// "a desk, 180 x 90 cm"
bool thing_precedes(const std::vector<Token>& tokens, std::size_t at, const KindTable& table) {
  if (at > 0 && tokens[at - 1].kind == Token::Kind::comma) --at;
  for (std::size_t n = 1; n <= ahead && n <= at; ++n)
    if (mention_at(table, tokens, at - n).length == n) return true;
  return false;
}

bool sensible(double side) {
  return side >= least_room_side && side <= greatest_room_side;
}

// Whether it is used.
bool set_size(const Vec2& size, Brief& brief) {
  if (!sensible(size.x()) || !sensible(size.y())) {
    brief.notes.push_back("the size in the prompt is beyond 0.5 to 50 m and was not used");
    return false;
  }
  if (!brief.size) brief.size = size;
  return *brief.size == size;
}

// "4 x 5 m": of a thing where one is named right after, else of the room; a third side is its
// height.
void read_sides(std::vector<Token>& tokens, std::size_t at, std::size_t count,
                const language::Measure& measure, const Vocabulary& words, const KindTable& table,
                Brief& brief) {
  const Vec2 size(measure.values[0], measure.values[1]);
  if (thing_follows(tokens, at + count, table, words) || thing_precedes(tokens, at, table)) {
    replace(tokens, at, count,
            {{Token::Kind::length, "length", size.x(), {}},
             {Token::Kind::length, "depth", size.y(), {}}});
  } else if (measure.has_unit || size.maxCoeff() <= metres_up_to) {
    if (set_size(size, brief)) hear(brief, source_of(tokens, at, count), Heard::As::room, "size");
    replace(tokens, at, count);
  }
}

// Whether it is used.
bool set_area(double area, Brief& brief) {
  if (area < least_room_side * least_room_side || area > greatest_room_side * greatest_room_side) {
    brief.notes.push_back(
        "the floor area in the prompt is beyond 0.25 to 2500 m2 and was not used");
    return false;
  }
  brief.area = area;
  return true;
}

bool is_ceiling(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && (tokens[at].is_word("ceiling") || tokens[at].is_word("ceilings"));
}

// "a ceiling of 2.9 m", "2.7 m high ceilings", "height 2.9 m" of the room: the tokens before it that
// say so; nothing where the length is of something else.
std::optional<std::size_t> ceiling_before(const std::vector<Token>& tokens, std::size_t at,
                                          const KindTable& table) {
  static const WordSet joints = {"of", "is", "are", "at", "a", "height", "about", "being"};
  bool height = false;
  for (std::size_t n = 1; n <= 4 && n <= at; ++n) {
    const Token& token = tokens[at - n];
    if (is_ceiling(tokens, at - n)) return n;
    height = height || token.is_word("height");
    const bool ends = token.kind == Token::Kind::stop || token.kind == Token::Kind::comma;
    if (ends || !joints.count(token.text)) {
      const bool of_thing = !ends && mention_at(table, tokens, at - n).length > 0;
      return height && !of_thing ? std::optional(n - 1) : std::nullopt;
    }
  }
  return std::nullopt;
}

// Whether a length was that of the ceiling above the floor.
bool read_ceiling(std::vector<Token>& tokens, std::size_t at, std::size_t count,
                  const language::Measure& measure, const KindTable& table, Brief& brief) {
  const double height = measure.values[0];
  const auto before = ceiling_before(tokens, at, table);
  const std::size_t behind = is_ceiling(tokens, at + count)       ? 1
                             : is_ceiling(tokens, at + count + 1) ? 2
                                                                  : 0;
  if ((!before && behind == 0) || height < least_ceiling || height > greatest_ceiling) return false;
  brief.height = height;
  const std::size_t first = at - before.value_or(0);
  const std::size_t length = count + before.value_or(0) + (before ? 0 : behind);
  hear(brief, source_of(tokens, first, length), Heard::As::room, "height");
  replace(tokens, at, count);
  return true;
}

// Whether any thing is named before.
bool thing_came_before(const std::vector<Token>& tokens, std::size_t at, const KindTable& table) {
  for (std::size_t i = 0; i < at; ++i)
    if (tokens[i].kind == Token::Kind::word && mention_at(table, tokens, i).length > 0) return true;
  return false;
}

// "16 m deep, 9 m wide, 5 m high", said before any thing is named.
class RoomSides {
 public:
  // Whether the length was one of the room's.
  bool read(const language::Measure& measure, const language::Run& tokens, Brief& brief) {
    switch (measure.side) {
      case language::Measure::Side::height:
        // A height alone is rather that of something whose name nobody knows.
        if (!brief.size && !brief.area) return false;
        if (measure.values[0] < least_ceiling || measure.values[0] > greatest_ceiling) return false;
        brief.height = measure.values[0];
        hear(brief, tokens, Heard::As::room, "height");
        return true;
      case language::Measure::Side::width:
        width_ = measure.values[0];
        break;
      case language::Measure::Side::depth:
      case language::Measure::Side::length:
        depth_ = measure.values[0];
        break;
      default:
        return false;
    }
    said_.push_back(tokens);
    if (width_ && depth_ && set_size({*width_, *depth_}, brief))
      for (const auto& run : said_) hear(brief, run, Heard::As::room, "size");
    return true;
  }

 private:
  std::optional<double> width_, depth_;
  std::vector<language::Run> said_;
};

// The tokens from `at` on whose source ends before `end`.
std::size_t count_up_to(const std::vector<Token>& tokens, std::size_t at, std::size_t end) {
  std::size_t count = 0;
  while (at + count < tokens.size() && tokens[at + count].source.end <= end) ++count;
  return count;
}

// "a 3 by 3 grid" of things.
bool is_grid(const std::vector<Token>& tokens, std::size_t at, const Vocabulary& words) {
  return at < tokens.size() && words.rows.count(tokens[at].text) > 0;
}

std::optional<int> number_at(const std::vector<Token>& tokens, std::size_t at,
                             const Vocabulary& words) {
  if (at >= tokens.size()) return std::nullopt;
  if (tokens[at].kind == Token::Kind::number) {
    const double value = tokens[at].value;
    return value >= 1 && value <= 10000 ? std::optional<int>(static_cast<int>(value)) : std::nullopt;
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

// "max 12 people": so many, wherever it is said.
People counted_people(const std::vector<Token>& tokens, std::size_t at, const Vocabulary& words) {
  static const WordSet anybody = {"people", "persons", "adults"};
  const auto count = number_at(tokens, at, words);
  if (!count || *count < 2 || !anybody.count(tokens[at + 1].text)) return {};
  return {*count, 2};
}

}  // namespace

void read_measures(std::vector<Token>& tokens, const std::vector<language::Token>& prompt,
                   const Vocabulary& words, const KindTable& table, Brief& brief) {
  RoomSides sides;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == Token::Kind::length || tokens[i].kind == Token::Kind::room) continue;
    const auto begin = tokens[i].source.begin;
    const auto measure = language::measure_at(prompt, begin);
    if (!measure) continue;
    const std::size_t count = count_up_to(tokens, i, begin + measure->length);
    if (count == 0 || is_grid(tokens, i + count, words)) continue;
    switch (measure->kind) {
      case language::Measure::Kind::area:
        if (set_area(measure->values[0], brief))
          hear(brief, source_of(tokens, i, count), Heard::As::room, "area");
        replace(tokens, i, count);
        break;
      case language::Measure::Kind::sides:
        read_sides(tokens, i, count, *measure, words, table, brief);
        break;
      case language::Measure::Kind::range:
        continue;
      case language::Measure::Kind::length:
        if (read_ceiling(tokens, i, count, *measure, table, brief)) break;
        if (!thing_follows(tokens, i + count, table, words) &&
            !thing_came_before(tokens, i, table) &&
            sides.read(*measure, source_of(tokens, i, count), brief)) {
          replace(tokens, i, count);
          break;
        }
        replace(tokens, i, count, {{Token::Kind::length, "length", measure->values[0], {}}});
    }
  }
}

void read_people(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                 Brief& brief) {
  static const WordSet leads = {"for", "seats", "seating", "sleeps"};
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const std::size_t lead = leads.count(tokens[i].text) ? 1 : 0;
    const People people = lead ? people_at(tokens, i + 1, words, table) : counted_people(tokens, i, words);
    if (people.length == 0) continue;
    if (brief.people == 0) {
      brief.people = std::min(people.count, most_people);
      if (people.count > most_people)
        brief.notes.push_back("a room is furnished for at most " + std::to_string(most_people) + " people, not for " +
                              std::to_string(people.count));
    }
    if (brief.people == std::min(people.count, most_people))
      hear(brief, source_of(tokens, i, people.length + lead), Heard::As::person);
    replace(tokens, i, people.length + lead);
    if (i > 0) --i;
  }
}

}  // namespace roomgen::brief
