#include "spoken_parts.h"

#include <algorithm>

#include "language/measure.h"
#include "language/number.h"

namespace roomgen {

namespace {

constexpr double greatest_turn = 360.0;

// "90", "a hundred and thirty": degrees, if they may be.
std::optional<double> degrees_at(const EditText& text, std::size_t at, std::size_t end) {
  const auto number = language::number_at(text.raw, at);
  if (!number || at + number->length > end || number->value < 1.0 || number->value > greatest_turn) return std::nullopt;
  return number->value;
}

// "an eighth of a turn", "half a turn", "three quarters"
std::optional<double> share_of_turn(const EditText& text, std::size_t at) {
  if (const auto turn = longest(text.edits.turns, text.tokens, at)) return *turn.value;
  if (const auto share = longest(text.edits.shares, text.tokens, at)) return greatest_turn * *share.value;
  return std::nullopt;
}

bool may_say_how_far(EditRole role) {
  return role == EditRole::amount || role == EditRole::place || role == EditRole::order;
}

}  // namespace

std::optional<RoleStretch> length_within(const EditText& text, const RoleStretch& part) {
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const auto measure = language::measure_at(text.raw, i);
    if (measure && measure->kind == language::Measure::Kind::length && i + measure->length <= part.end)
      return RoleStretch{part.role, i, i + measure->length};
    if (const auto vague = longest(text.edits.amounts, text.tokens, i); vague && i + vague.length <= part.end)
      return RoleStretch{part.role, i, i + vague.length};
  }
  return std::nullopt;
}

std::optional<double> turn_within(const EditText& text, const SpokenOrder& order) {
  std::optional<double> degrees;
  double sign = 1.0;
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; may_say_how_far(part.role) && i < part.end; ++i) {
      if (const auto way = longest(text.edits.turn_directions, text.tokens, i)) sign = *way.value;
      if (part.role == EditRole::order || degrees) continue;
      degrees = degrees_at(text, i, part.end);
      if (!degrees) degrees = share_of_turn(text, i);
    }
  if (!degrees) return std::nullopt;
  return sign * *degrees;
}

std::optional<std::vector<double>> sides_within(const EditText& text, const RoleStretch& part) {
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const auto measure = language::measure_at(text.raw, i);
    if (!measure || measure->kind != language::Measure::Kind::sides || i + measure->length > part.end) continue;
    // Nobody has furniture of 60 m.
    const double unit = measure->has_unit || measure->values[0] < 10.0 ? 1.0 : 0.01;
    std::vector<double> sides;
    for (int k = 0; k < measure->count; ++k) sides.push_back(unit * measure->values[k]);
    return sides;
  }
  return std::nullopt;
}

std::string plain_look_of(const EditText& text, const RoleStretch& part) {
  std::size_t begin = part.begin, end = part.end;
  const auto is_small = [&](std::size_t i) {
    return text.is_mark(i) || text.edits.words_of_looks.count(text.tokens[i].text) > 0 || text.is_word(i, "some") ||
           text.is_word(i, "into") || longest_in(text.edits.something, text.tokens, i) > 0;
  };
  while (begin < end && is_small(begin)) ++begin;
  while (end > begin && (text.is_mark(end - 1) || text.is_word(end - 1, "one") || text.is_word(end - 1, "ones"))) --end;
  std::string words;
  for (std::size_t i = begin; i < end; ++i)
    if (!text.is_mark(i) && !text.is_word(i, "one") && !text.is_word(i, "ones"))
      words += (words.empty() ? "" : " ") + text.tokens[i].text;
  return words;
}

}  // namespace roomgen
