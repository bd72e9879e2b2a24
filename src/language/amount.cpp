#include "amount.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "number.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

using Tokens = std::span<const Token>;
constexpr double unbounded = std::numeric_limits<double>::infinity();

bool is_word_at(Tokens tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].is(word);
}

bool is_sign_at(Tokens tokens, std::size_t at, std::string_view sign) {
  return at < tokens.size() && tokens[at].kind == Token::Kind::symbol && tokens[at].text == sign;
}

// "%", "percent", "per cent"
std::size_t percent_at(Tokens tokens, std::size_t at) {
  if (is_sign_at(tokens, at, "%") || is_word_at(tokens, at, "percent") || is_word_at(tokens, at, "pct")) return 1;
  return is_word_at(tokens, at, "per") && is_word_at(tokens, at + 1, "cent") ? 2 : 0;
}

/// A number, or a share with its sign.
struct Figure {
  double value = 0.0;
  bool is_share = false;
  std::size_t length = 0;
};

// "a third", "two thirds", "three quarters", "half"
std::optional<Figure> fraction_at(Tokens tokens, std::size_t at) {
  const auto& fractions = small_words().fractions;
  const auto part = [&](std::size_t token) -> const double* {
    if (token >= tokens.size() || tokens[token].kind != Token::Kind::word) return nullptr;
    const auto found = fractions.find(tokens[token].text);
    return found == fractions.end() ? nullptr : &found->second;
  };
  if (const double* alone = part(at); alone && *alone == 0.5 && !is_word_at(tokens, at + 1, "a"))
    return Figure{*alone, true, 1};
  if (is_word_at(tokens, at, "a") || is_word_at(tokens, at, "one"))
    if (const double* one = part(at + 1)) return Figure{*one, true, 2};
  if (const auto number = at < tokens.size() ? number_at(tokens.first(at + 1), at) : std::nullopt;
      number && number->value >= 1)
    if (const double* each = part(at + 1); each && tokens[at + 1].text.ends_with('s'))
      return Figure{number->value * *each, true, 2};
  return std::nullopt;
}

std::optional<Figure> figure_at(Tokens tokens, std::size_t at) {
  if (const auto fraction = fraction_at(tokens, at)) return fraction;
  const auto number = number_at(tokens, at);
  if (!number) return std::nullopt;
  const std::size_t sign = percent_at(tokens, at + number->length);
  if (sign > 0) return Figure{number->value / 100.0, true, number->length + sign};
  return Figure{number->value, false, number->length};
}

bool joins(Tokens tokens, std::size_t at, bool after_between) {
  if (at >= tokens.size()) return false;
  const Token& token = tokens[at];
  if (token.kind == Token::Kind::symbol)
    return token.text == "-" || token.text == "–" || token.text == "—" || token.text == "~";
  return token.is("to") || token.is("through") || token.is("till") || token.is(after_between ? "and" : "or");
}

// What joins two figures: a word, a dash, or a hyphen that left no token of its own. Tokens, if it does.
std::optional<std::size_t> joint_at(Tokens tokens, std::size_t at, bool after_between) {
  if (joins(tokens, at, after_between)) return 1;
  if (at < tokens.size() && tokens[at].joint == Token::Joint::hyphen && tokens[at].kind == Token::Kind::number)
    return 0;
  return std::nullopt;
}

// "8 to 12", "between 8 and 12", "from 8 to 12", "8"
std::optional<Amount> span_at(Tokens tokens, std::size_t at) {
  const bool is_between = is_word_at(tokens, at, "between");
  const std::size_t begin = at + (is_between || is_word_at(tokens, at, "from") ? 1 : 0);
  const auto first = figure_at(tokens, begin);
  if (!first) return std::nullopt;
  const std::size_t behind = begin + first->length;
  if (const auto joint = joint_at(tokens, behind, is_between))
    if (const auto second = figure_at(tokens, behind + *joint)) {
      // The sign of "30 to 40 %" is of both.
      const double low = second->is_share && !first->is_share ? first->value / 100.0 : first->value;
      if (low < second->value)
        return Amount{low, second->value, second->is_share, false, behind + *joint + second->length - at};
    }
  if (begin != at) return std::nullopt;
  return Amount{first->value, first->value, first->is_share, false, first->length};
}

enum class Bounding { none, exactly, least, most, above, below, about };

struct BoundWords {
  Bounding bounding = Bounding::none;
  std::size_t length = 0;
};

BoundWords bounding_before(Tokens tokens, std::size_t at) {
  const SmallWords& words = small_words();
  if (const auto n = longest_run(words.excluded_lower_limits, tokens, at)) return {Bounding::above, n};
  if (const auto n = longest_run(words.excluded_upper_limits, tokens, at)) return {Bounding::below, n};
  if (const auto n = longest_run(words.upper_limits, tokens, at)) return {Bounding::most, n};
  if (const auto n = longest_run(words.lower_limits, tokens, at)) return {Bounding::least, n};
  if (const auto n = longest_run(words.exact, tokens, at)) return {Bounding::exactly, n};
  if (const auto n = longest_run(words.approximations, tokens, at)) return {Bounding::about, n};
  if (is_sign_at(tokens, at, "~")) return {Bounding::about, 1};
  return {};
}

BoundWords bounding_behind(Tokens tokens, std::size_t at) {
  const SmallWords& words = small_words();
  if (is_sign_at(tokens, at, "+")) return {Bounding::least, 1};
  if (const auto n = longest_run(words.lower_limits_behind, tokens, at)) return {Bounding::least, n};
  if (const auto n = longest_run(words.upper_limits_behind, tokens, at)) return {Bounding::most, n};
  if (const auto n = longest_run(words.approximations_behind, tokens, at)) return {Bounding::about, n};
  return {};
}

// The next whole number of what is counted; of a share the bound itself.
double beyond(const Amount& amount, double value, double step) {
  return amount.is_share || value != std::floor(value) ? value : value + step;
}

void apply(Bounding bounding, Amount& amount) {
  switch (bounding) {
    case Bounding::none: case Bounding::exactly: return;
    case Bounding::about: amount.is_about = true; return;
    case Bounding::least: amount.high = unbounded; return;
    case Bounding::most: amount.low = 0.0; return;
    case Bounding::above: amount.low = beyond(amount, amount.low, 1.0), amount.high = unbounded; return;
    case Bounding::below: amount.high = std::max(0.0, beyond(amount, amount.high, -1.0)), amount.low = 0.0; return;
  }
}

}  // namespace

std::pair<double, double> counted_bounds(const Amount& amount) {
  constexpr double about = 0.2, rounding = 1e-9;
  if (!amount.is_about) return {amount.low, amount.high};
  return {std::ceil(amount.low * (1.0 - about) - rounding), std::floor(amount.high * (1.0 + about) + rounding)};
}

std::optional<Amount> amount_at(Tokens tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  const BoundWords before = bounding_before(tokens, at);
  auto amount = span_at(tokens, at + before.length);
  if (!amount) return std::nullopt;
  apply(before.bounding, *amount);
  amount->length += before.length;
  const BoundWords behind = bounding_behind(tokens, at + amount->length);
  if (before.bounding == Bounding::none) apply(behind.bounding, *amount);
  amount->length += behind.length;
  return amount;
}

}  // namespace roomgen::language
