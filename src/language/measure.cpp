#include "measure.h"

#include <algorithm>

#include "number.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

using Units = std::map<std::string, double, std::less<>>;

// No room is longer (docs/limits.md), so that what is told can be planned and written.
constexpr double longest_length = 1000.0;

struct UnitWord {
  double factor = 0.0;
  std::size_t length = 0;
};

UnitWord unit_at(const Units& units, std::span<const Token> tokens, std::size_t at) {
  UnitWord best;
  std::string name;
  for (std::size_t n = 0; n < 2 && at + n < tokens.size(); ++n) {
    const auto kind = tokens[at + n].kind;
    if (kind != Token::Kind::word && kind != Token::Kind::number) break;
    name += (n ? " " : "") + tokens[at + n].text;
    if (const auto found = units.find(name); found != units.end()) best = {found->second, n + 1};
  }
  return best;
}

bool is_word(std::span<const Token> tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].is(word);
}

// "in" is inches where a number of them can be: not in "two chairs, 3 in the corner".
bool is_preposition(std::span<const Token> tokens, std::size_t at) {
  if (!is_word(tokens, at, "in") || tokens[at].joint != Token::Joint::apart) return false;
  return at + 1 < tokens.size() && tokens[at + 1].kind == Token::Kind::word &&
         !small_words().sides.count(tokens[at + 1].text) && !is_word(tokens, at + 1, "x") &&
         !is_word(tokens, at + 1, "by");
}

// One length: "1.8 m", "5 feet 10 inches", "half a metre", "3" without a unit.
struct Length {
  double value = 0.0, factor = 0.0;  ///< factor 0: no unit
  std::size_t length = 0;
};

std::optional<Length> length_at(std::span<const Token> tokens, std::size_t at) {
  auto number = number_at(tokens, at);
  // "a metre": an article is a number here.
  if (!number && (is_word(tokens, at, "a") || is_word(tokens, at, "an")) &&
      unit_at(small_words().lengths, tokens, at + 1).length && at + 1 < tokens.size() &&
      tokens[at + 1].text.size() > 2)
    number = Number{1.0, 1};
  if (!number) return std::nullopt;
  Length length{number->value, 0.0, number->length};
  std::size_t next = at + length.length;
  // "half a metre"
  if (length.value < 1.0 && is_word(tokens, next, "a") &&
      unit_at(small_words().lengths, tokens, next + 1).length)
    ++next;
  const UnitWord unit =
      is_preposition(tokens, next) ? UnitWord{} : unit_at(small_words().lengths, tokens, next);
  if (unit.length == 0) return length;
  length.factor = unit.factor;
  length.length = next + unit.length - at;
  // "5 feet 10", "6 ft 2 in", "1 m 80"
  const std::size_t more = at + length.length;
  const double smaller = unit.factor == 0.3048 ? 1.0 / 12.0 : unit.factor == 1.0 ? 0.01 : 0.0;
  if (smaller > 0 && more < tokens.size() && tokens[more].kind == Token::Kind::number) {
    const UnitWord second = is_preposition(tokens, more + 1)
                            ? UnitWord{}
                            : unit_at(small_words().lengths, tokens, more + 1);
    const bool inches = smaller < 0.1 && smaller > 0.05;
    if (second.length ? second.factor < unit.factor
                      : inches && tokens[more].joint == Token::Joint::none) {
      length.value += tokens[more].value * (second.length ? second.factor / unit.factor : smaller);
      length.length += 1 + second.length;
    }
  }
  return length;
}

bool joins_sides(std::span<const Token> tokens, std::size_t at) {
  return is_word(tokens, at, "x") || is_word(tokens, at, "by") || is_word(tokens, at, "times");
}

// "2-3 m", "2 to 3 metres"
bool joins_range(std::span<const Token> tokens, std::size_t at, std::size_t& next) {
  if (at >= tokens.size()) return false;
  if (tokens[at].kind == Token::Kind::number && tokens[at].joint == Token::Joint::hyphen) {
    next = at;
    return true;
  }
  next = at + 1;
  return is_word(tokens, at, "to") ||
         (tokens[at].text == "-" && tokens[at].kind == Token::Kind::symbol);
}

// All values in metres once the last has said its unit.
void convert(Measure& measure, const Length* sides) {
  double factor = 0.0;
  for (int i = measure.count; i-- > 0;) {
    if (sides[i].factor > 0) factor = sides[i].factor;
    if (factor == 0.0)
      for (int k = 0; k < i && factor == 0.0; ++k) factor = sides[k].factor;
    measure.values[i] = std::min(sides[i].value * (factor > 0 ? factor : 1.0), longest_length);
  }
  measure.has_unit = factor > 0;
}

void read_side(Measure& measure, std::span<const Token> tokens, std::size_t at) {
  std::size_t i = at + measure.length;
  if (is_word(tokens, i, "in")) ++i;
  if (i >= tokens.size() || tokens[i].kind != Token::Kind::word) return;
  const auto found = small_words().sides.find(tokens[i].text);
  // "1.2 m across the room": a preposition.
  if (found == small_words().sides.end() ||
      (tokens[i].text == "across" && is_word(tokens, i + 1, "the")))
    return;
  measure.side = found->second;
  measure.length = i + 1 - at;
}

std::optional<Measure> area_at(std::span<const Token> tokens, std::size_t at) {
  const auto number = number_at(tokens, at);
  if (!number) return std::nullopt;
  const UnitWord unit = unit_at(small_words().areas, tokens, at + number->length);
  if (unit.length == 0) return std::nullopt;
  Measure area;
  area.kind = Measure::Kind::area;
  area.values[0] = std::min(number->value * unit.factor, longest_length * longest_length);
  area.length = number->length + unit.length;
  return area;
}

}  // namespace

std::optional<Measure> measure_at(std::span<const Token> tokens, std::size_t at) {
  if (const auto area = area_at(tokens, at)) return area;
  const auto first = length_at(tokens, at);
  if (!first) return std::nullopt;
  Measure measure;
  Length sides[3] = {*first};
  measure.length = first->length;
  while (measure.count < 3 && joins_sides(tokens, at + measure.length)) {
    const auto next = length_at(tokens, at + measure.length + 1);
    if (!next) break;
    sides[measure.count++] = *next;
    measure.length += 1 + next->length;
  }
  std::size_t next = 0;
  if (measure.count > 1) {
    measure.kind = Measure::Kind::sides;
  } else if (joins_range(tokens, at + measure.length, next)) {
    if (const auto most = length_at(tokens, next); most && most->factor > 0) {
      measure.kind = Measure::Kind::range;
      sides[measure.count++] = *most;
      measure.length = next + most->length - at;
    }
  }
  convert(measure, sides);
  if (measure.count == 1 && !measure.has_unit) return std::nullopt;
  if (measure.kind != Measure::Kind::sides) read_side(measure, tokens, at);
  return measure;
}

Bound bound_at(std::span<const Token> tokens, std::size_t at) {
  using Limit = Measure::Limit;
  const SmallWords& words = small_words();
  if (const auto most = longest_run(words.upper_limits, tokens, at)) return {Limit::most, {}, most};
  if (const auto least = longest_run(words.lower_limits, tokens, at)) return {Limit::least, {}, least};
  const bool is_denied = is_word(tokens, at, "no") || is_word(tokens, at, "not");
  const std::size_t word = at + (is_denied ? 1 : 0);
  if (word >= tokens.size() || !is_word(tokens, word + 1, "than")) return {};
  const auto comparative = words.comparatives.find(tokens[word].text);
  if (comparative == words.comparatives.end()) return {};
  return {is_denied ? Limit::most : Limit::least, comparative->second, word + 2 - at};
}

std::optional<Measure> bounded_measure_at(std::span<const Token> tokens, std::size_t at) {
  const Bound bound = bound_at(tokens, at);
  auto measure = measure_at(tokens, at + bound.length);
  if (!measure || bound.length == 0) return measure;
  measure->limit = bound.limit;
  measure->length += bound.length;
  if (measure->side == Measure::Side::unsaid) measure->side = bound.side;
  return measure;
}

}  // namespace roomgen::language
