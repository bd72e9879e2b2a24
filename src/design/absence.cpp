#include "absence.h"

#include <algorithm>

#include "noun_phrase.h"

namespace roomgen::design {

namespace {

constexpr std::size_t furthest = 200;  ///< tokens that one negation reaches
constexpr std::size_t window_words = 4;
constexpr double most_windows = 10;

bool is_word(std::span<const Token> tokens, std::size_t i, std::string_view word) {
  return i < tokens.size() && tokens[i].is_word(word);
}

bool is_window(std::span<const Token> tokens, std::size_t i) {
  return is_word(tokens, i, "window") || is_word(tokens, i, "windows");
}

// What may stand between a negation and its nouns: "do not add any …, … or …".
bool joins(const Token& token, const Vocabulary& words) {
  static const WordSet fillers = {"or",      "nor",  "and", "any", "have",
                                  "include", "want", "add", "put"};
  return token.kind == Token::Kind::comma || fillers.count(token.text) ||
         words.negations.count(token.text);
}

}  // namespace

std::optional<Absence> read_absence(std::span<const Token> tokens, std::size_t at,
                                    const Vocabulary& words, const KindNames& names) {
  if (tokens[at].kind != Token::Kind::word || !words.negations.count(tokens[at].text))
    return std::nullopt;
  Absence absence;
  const auto found = [&] { return absence.windows || !absence.kinds.empty(); };
  std::size_t i = at + 1;
  while (i < tokens.size() && i < at + furthest) {
    if (joins(tokens[i], words)) {
      ++i;
    } else if (is_window(tokens, i)) {
      absence.windows = true;
      ++i;
    } else {
      const auto phrase = read_noun_phrase(tokens, i, words, names, false);
      if (!phrase || phrase->kind.length == 0 || (found() && phrase->article)) break;
      absence.kinds.push_back(phrase->kind);
      i = phrase->end;
    }
  }
  if (!found()) return std::nullopt;
  absence.end = i;
  return absence;
}

std::size_t read_only(std::span<const Token> tokens, std::size_t at, const Vocabulary& words) {
  if (tokens[at].kind != Token::Kind::word) return at;
  const auto next_is = [&](std::initializer_list<std::string_view> options) {
    return std::any_of(options.begin(), options.end(),
                       [&](std::string_view word) { return is_word(tokens, at + 1, word); });
  };
  if (tokens[at].text == "nothing" && next_is({"else", "more"})) return at + 2;
  if (tokens[at].text == "no" && next_is({"other", "more", "additional"})) return at + 2;
  if (at == 0 || !words.only.count(tokens[at].text)) return at;
  static const WordSet holders = {"with", "containing", "contains", "has"};
  return holders.count(tokens[at - 1].text) ? at + 1 : at;
}

std::optional<Windows> read_windows(std::span<const Token> tokens, std::size_t at,
                                    const Vocabulary& words, const KindNames& names) {
  Windows windows;
  for (std::size_t i = at; i < tokens.size() && i < at + window_words; ++i) {
    const Token& token = tokens[i];
    if (is_window(tokens, i)) {
      windows.plural = token.text == "windows";
      windows.end = i + 1;
      return windows;
    }
    if (token.kind == Token::Kind::number) {
      windows.count = static_cast<int>(std::min(token.value, most_windows));
      windows.counted = true;
    } else if (token.kind != Token::Kind::word ||
               (words.stops.count(token.text) && token.text != "the")) {
      return std::nullopt;
    } else if (const auto number = words.numbers.find(token.text); number != words.numbers.end()) {
      windows.count = std::min(number->second, static_cast<int>(most_windows));
      windows.counted = windows.count > 1;
    } else if (names.match(tokens, i).length > 0) {
      return std::nullopt;
    } else if (const auto size = words.sizes.find(token.text); size != words.sizes.end()) {
      windows.wide = windows.wide || size->second.x() > 1.0;
    }
  }
  return std::nullopt;
}

}  // namespace roomgen::design
