#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomgen::design {

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
  double value = 0.0;  ///< of a number or a length

  bool is_word(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// The longest prompt that is read, in tokens; the rest is ignored.
inline constexpr std::size_t max_tokens = 4000;

/// Splits a prompt. Hyphens part words, "4x5m" gives 4, x, 5, m, possessives lose their s, and
/// marks of other scripts that mean the same are understood.
std::vector<Token> tokenize(std::string_view text);

}  // namespace roomgen::design
