#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace roomgen::language {

/// Bytes of a text: the first, and one past the last.
struct Span {
  std::uint32_t begin = 0, end = 0;

  std::uint32_t size() const { return end - begin; }
  std::string_view of(std::string_view text) const { return text.substr(begin, size()); }
  friend bool operator==(const Span&, const Span&) = default;
};

/// A piece of a text.
struct Token {
  enum class Kind : std::uint8_t {
    word,
    number,   ///< in figures: 2, 1.5, 1,200, ½
    ordinal,  ///< in figures: 1st
    comma,
    stop,  ///< ends a clause: . ! ? ; : and the end of a line
    open,  ///< a bracket
    close,
    quote,
    symbol  ///< anything else: / % # ...
  };
  /// What stands between a token and the one before it.
  enum class Joint : std::uint8_t { apart, hyphen, none };

  Kind kind = Kind::word;
  Joint joint = Joint::apart;
  Span span;
  std::string text;    ///< in lower case, plain apostrophes; a word without its clitic, and of one over longest_word its start
  std::string clitic;  ///< "'s", "'", "n't", "'re", ...: of "there's", "kids'", "don't"
  double value = 0.0;  ///< of a number or an ordinal

  bool is(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// Of a word, in bytes; no name of anything comes near.
inline constexpr std::size_t longest_word = 60;

/// The longest text that is read, in tokens; the rest is ignored.
inline constexpr std::size_t max_tokens = 50'000;

/// Splits a text; the spans are in order and cover all but white space and hyphens that join words.
/// Hyphens part words ("bean-bag" gives bean, bag), as do changes between letters and figures
/// ("4x5m" gives 4, x, 5, m; but "m2" and "1970s" are words). A foot or inch mark behind a number
/// is the word ft or in; & and + are the word and, w/ is with. Any bytes may be given: what is no UTF-8 is
/// taken for letters.
std::vector<Token> tokenize(std::string_view text, std::size_t most = max_tokens);

}  // namespace roomgen::language
