#include "tokens.h"

namespace roomgen::brief {

namespace {

// No English word comes near; a longer run of letters names nothing that could be put into a room.
constexpr std::size_t longest_word = 60;

Token plain(const language::Token& token) {
  using Kind = language::Token::Kind;
  if (token.text.size() > longest_word) return {Token::Kind::comma, ",", 0.0, {}};
  switch (token.kind) {
    case Kind::number:
      return {Token::Kind::number, token.text, token.value, {}};
    case Kind::word:
    case Kind::ordinal:
      return {Token::Kind::word, token.clitic == "n't" ? token.text + "nt" : token.text, 0.0, {}};
    case Kind::stop:
      return {Token::Kind::stop, ".", 0.0, {}};
    default:
      return {Token::Kind::comma, ",", 0.0, {}};
  }
}

bool means_nothing(const language::Token& token) {
  return token.kind == language::Token::Kind::quote || token.kind == language::Token::Kind::symbol;
}

}  // namespace

std::vector<Token> plain_tokens(const std::vector<language::Token>& tokens) {
  std::vector<Token> result;
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    result.push_back(plain(tokens[i]));
    result.back().source = {i, i + 1};
  }
  return result;
}

std::vector<Token> meaningful_tokens(const std::vector<language::Token>& tokens) {
  auto result = plain_tokens(tokens);
  std::erase_if(result,
                [&](const Token& token) { return means_nothing(tokens[token.source.begin]); });
  return result;
}

std::vector<Token> tokenize(std::string_view text) {
  return meaningful_tokens(language::tokenize(text, max_tokens));
}

language::Run source_of(const std::vector<Token>& tokens, std::size_t at, std::size_t count) {
  if (count == 0 || at + count > tokens.size()) return {};
  return {tokens[at].source.begin, tokens[at + count - 1].source.end};
}

void replace(std::vector<Token>& tokens, std::size_t at, std::size_t count,
             std::vector<Token> with) {
  for (Token& token : with)
    if (count > 0) token.source = source_of(tokens, at, count);
  const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(at);
  tokens.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(at), with.begin(), with.end());
}

}  // namespace roomgen::brief
