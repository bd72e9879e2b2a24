#include "absence.h"

#include <algorithm>

#include "noun_phrase.h"

namespace roomgen::design {

namespace {

constexpr std::size_t furthest = 200;  ///< tokens that one negation reaches

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
                                    const Vocabulary& words, const KindTable& table) {
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
      const auto phrase = read_noun_phrase(tokens, i, words, table, false);
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

}  // namespace roomgen::design
