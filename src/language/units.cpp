#include "units.h"

#include "function_word.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

bool is_hyphened(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].joint == Token::Joint::hyphen;
}

// "the other half" is no number, "second" no unit of time behind "the".
bool may_be_number(const std::vector<Token>& tokens, std::size_t at) {
  const auto& words = small_words();
  const bool is_behind_determiner = at > 0 && words.determiners.count(tokens[at - 1].text) > 0;
  if (is_behind_determiner && (words.fractions.count(tokens[at].text) || tokens[at].is("one")))
    return false;
  return !words.ordinals.count(tokens[at].text);
}

// "floor to ceiling shelves", but not "from floor to ceiling": how many tokens behind the first
// stand before a noun with it.
std::size_t compound_at(const std::vector<Token>& tokens, std::size_t at) {
  const std::size_t length = longest_run(small_words().compounds, tokens, at), end = at + length;
  const bool is_before_noun = end < tokens.size() && tokens[end].kind == Token::Kind::word &&
                              !is_function_word(tokens[end]);
  return length > 0 && is_before_noun && (at == 0 || !tokens[at - 1].is("from")) ? length - 1 : 0;
}

Unit mark_or_word(const std::vector<Token>& tokens, std::size_t at) {
  Unit unit;
  std::size_t end = at + 1;
  switch (tokens[at].kind) {
    case Token::Kind::stop:
      unit.kind = Unit::Kind::stop;
      break;
    case Token::Kind::comma:
    case Token::Kind::open:
    case Token::Kind::close:
      unit.kind = Unit::Kind::comma;
      break;
    default:
      end += compound_at(tokens, at);
      while (is_hyphened(tokens, end) && !small_words().conjunctions.count(tokens[end].text)) ++end;
  }
  unit.tokens = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
  return unit;
}

Unit unit_at(const std::vector<Token>& tokens, std::size_t at) {
  Unit unit;
  const auto run = [&](std::size_t length) {
    return Run{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + length)};
  };
  if (!may_be_number(tokens, at)) return mark_or_word(tokens, at);
  if (const auto measure = measure_at(tokens, at);
      measure && (measure->has_unit || measure->count > 1)) {
    unit.kind = Unit::Kind::measure;
    unit.tokens = run(measure->length);
    unit.measure = *measure;
    return unit;
  }
  const auto number = number_at(tokens, at);
  // "three-seater", "4-legged": part of a word.
  if (!number || is_hyphened(tokens, at + number->length)) return mark_or_word(tokens, at);
  unit.kind = Unit::Kind::number;
  unit.tokens = run(number->length);
  unit.value = number->value;
  return unit;
}

}  // namespace

std::vector<Unit> units(const std::vector<Token>& tokens) {
  std::vector<Unit> result;
  for (std::size_t at = 0; at < tokens.size();) {
    if (tokens[at].kind == Token::Kind::quote || tokens[at].kind == Token::Kind::symbol) {
      ++at;
      continue;
    }
    result.push_back(unit_at(tokens, at));
    at = result.back().tokens.end;
  }
  return result;
}

}  // namespace roomgen::language
