#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/parse.h"

namespace roomgen::brief {

/// A piece of a prompt: a word in lower case, a number, a mark, or what replaced several of them.
struct Token {
  enum class Kind {
    word,
    number,
    comma,   ///< ends a phrase
    stop,    ///< ends a sentence
    length,  ///< "1.8 m", in metres
    room,    ///< the name of a room
  };

  Kind kind = Kind::word;
  std::string text;
  double value = 0.0;    ///< of a number or a length
  language::Run source;  ///< of the prompt's own tokens

  bool is_word(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// The longest prompt that is read, in tokens; the rest is ignored.
inline constexpr std::size_t max_tokens = 4000;

/// One for each token, marks that mean nothing as commas: "don't" is one word, "kid's" has no
/// ending.
std::vector<Token> plain_tokens(const std::vector<language::Token>& tokens);

/// Those without the marks that mean nothing.
std::vector<Token> meaningful_tokens(const std::vector<language::Token>& tokens);

/// The meaningful tokens of a prompt.
std::vector<Token> tokenize(std::string_view text);

/// The prompt's own tokens that some of them stand for.
language::Run source_of(const std::vector<Token>& tokens, std::size_t at, std::size_t count);

/// Replaces some tokens by others, which have their source.
void replace(std::vector<Token>& tokens, std::size_t at, std::size_t count,
             std::vector<Token> with = {});

}  // namespace roomgen::brief
