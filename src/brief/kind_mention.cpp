#include "kind_mention.h"

#include <utility>

#include "language/inflection.h"

namespace roomgen::brief {

namespace {
constexpr std::size_t longest_name = 5;
}

std::vector<std::string> singulars(const std::string& word) {
  std::vector<std::string> forms{word};
  for (auto& form : language::singulars(word))
    if (form != word) forms.push_back(std::move(form));
  return forms;
}

namespace {

// "spools of thread": one thing's name, whose first word is in the plural.
KindMention mention_of(const KindTable& kinds, std::span<const Token> tokens, std::size_t at) {
  if (at + 2 >= tokens.size() || !tokens[at + 1].is_word("of")) return {};
  for (const auto& first : singulars(tokens[at].text)) {
    if (first == tokens[at].text) continue;
    const std::string name = first + " of " + tokens[at + 2].text;
    if (const Kind* category = kinds.spelled(name)) return {category, 3, true, name};
  }
  return {};
}

}  // namespace

KindMention mention_at(const KindTable& kinds, std::span<const Token> tokens, std::size_t at) {
  KindMention best;
  std::string before;
  for (std::size_t n = 0; n < longest_name && at + n < tokens.size(); ++n) {
    const Token& token = tokens[at + n];
    if (token.kind != Token::Kind::word && token.kind != Token::Kind::number) break;
    for (const auto& form : singulars(token.text))
      if (const Kind* category = kinds.spelled(before + form)) {
        best = {category, n + 1, form != token.text, before + form};
        break;
      }
    before += token.text + " ";
  }
  if (const KindMention several = mention_of(kinds, tokens, at); several.length > best.length) best = several;
  // "three" alone is no name even if "three seater" is one.
  if (best.length == 1 && tokens[at].kind == Token::Kind::number) return {};
  return best;
}

bool is_within_name(const KindTable& kinds, std::span<const Token> tokens, std::size_t at) {
  for (std::size_t n = 1; n < longest_name && n <= at; ++n)
    if (mention_at(kinds, tokens, at - n).length > n) return true;
  return false;
}

}  // namespace roomgen::brief
