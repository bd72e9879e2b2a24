#include "number.h"

#include "small_words.h"

namespace roomgen::language {

namespace {

const double* find(const std::map<std::string, double, std::less<>>& map,
                   std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::word) return nullptr;
  const auto found = map.find(tokens[at].text);
  return found == map.end() ? nullptr : &found->second;
}

bool is(std::span<const Token> tokens, std::size_t at, std::string_view word) {
  return at < tokens.size() && tokens[at].is(word);
}

bool is_article(std::span<const Token> tokens, std::size_t at) {
  return is(tokens, at, "a") || is(tokens, at, "an");
}

// "2", "1/2", "1 1/2"
std::optional<Number> in_figures(std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::number) return std::nullopt;
  const auto fraction = [&](std::size_t from) {
    return from + 2 < tokens.size() && tokens[from].kind == Token::Kind::number &&
           tokens[from + 1].text == "/" && tokens[from + 1].joint == Token::Joint::none &&
           tokens[from + 2].kind == Token::Kind::number &&
           tokens[from + 2].joint == Token::Joint::none && tokens[from + 2].value > 0;
  };
  if (fraction(at)) return Number{tokens[at].value / tokens[at + 2].value, 3};
  if (at + 1 < tokens.size() && tokens[at + 1].joint == Token::Joint::apart && fraction(at + 1))
    return Number{tokens[at].value + tokens[at + 1].value / tokens[at + 3].value, 4};
  return Number{tokens[at].value, 1};
}

constexpr double greatest = 1e9;  // nothing that is counted in words is more

// "twenty-one", "two hundred and five", "three dozen"
std::optional<Number> in_words(std::span<const Token> tokens, std::size_t at) {
  Number number;
  double part = 0.0;
  std::size_t i = at;
  bool any = false;
  for (; i < tokens.size(); ++i) {
    if (const double* units = find(small_words().numbers, tokens, i)) {
      // "two three" are two numbers, "twenty two" is one.
      const bool fits = part == 0.0 ||
                        (part >= 20 && static_cast<int>(part) % 10 == 0 && *units < 10) ||
                        (static_cast<int>(part) % 100 == 0 && part >= 100);
      if (any && !fits) break;
      part += *units;
    } else if (const double* scale = find(small_words().scales, tokens, i);
               scale && (any || i == at)) {
      part = (part == 0.0 ? 1.0 : part) * *scale;
      if (*scale >= 1000) {
        number.value += part;
        part = 0.0;
      }
    } else if (any && is(tokens, i, "and") && find(small_words().numbers, tokens, i + 1) &&
               (part >= 100 || number.value >= 1000) && static_cast<int>(part) % 100 == 0) {
      continue;
    } else {
      break;
    }
    any = true;
    if (part > greatest || number.value > greatest) return std::nullopt;
  }
  if (!any) return std::nullopt;
  return Number{number.value + part, i - at};
}

// "half", "half a dozen", "a quarter", "three quarters" (of what has been read)
std::optional<Number> fraction_at(std::span<const Token> tokens, std::size_t at) {
  const double* fraction = find(small_words().fractions, tokens, at);
  if (!fraction) return std::nullopt;
  // "a half dozen", "half a dozen"
  const std::size_t next = is_article(tokens, at + 1) ? at + 2 : at + 1;
  if (const double* scale = find(small_words().scales, tokens, next))
    return Number{*fraction * *scale, next + 1 - at};
  return Number{*fraction, 1};
}

}  // namespace

std::optional<Number> number_at(std::span<const Token> tokens, std::size_t at) {
  if (is_article(tokens, at)) {
    auto behind = find(small_words().scales, tokens, at + 1) ? in_words(tokens, at + 1)
                                                             : fraction_at(tokens, at + 1);
    if (!behind) return std::nullopt;
    return Number{behind->value, behind->length + 1, true};
  }
  auto number = in_figures(tokens, at);
  if (!number) number = in_words(tokens, at);
  if (!number) return fraction_at(tokens, at);
  std::size_t next = at + number->length;
  if (number->length == 1)
    if (const double* scale = find(small_words().scales, tokens, next);
        scale && tokens[at].kind == Token::Kind::number) {
      number->value *= *scale;
      ++number->length;
      ++next;
    }
  // "two and a half", "three quarters"
  if (is(tokens, next, "and"))
    if (const auto part =
            is_article(tokens, next + 1) ? fraction_at(tokens, next + 2) : std::nullopt;
        part && part->length == 1)
      return Number{number->value + part->value, number->length + 3};
  if (const double* fraction = find(small_words().fractions, tokens, next);
      fraction && tokens[next].text.ends_with('s'))
    return Number{number->value * *fraction, number->length + 1};
  return number;
}

std::optional<int> ordinal_at(std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  if (tokens[at].kind == Token::Kind::ordinal && tokens[at].value < 1e6)
    return static_cast<int>(tokens[at].value);
  const double* found = find(small_words().ordinals, tokens, at);
  return found ? std::optional<int>(static_cast<int>(*found)) : std::nullopt;
}

}  // namespace roomgen::language
