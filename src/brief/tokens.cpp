#include "tokens.h"

#include <array>
#include <utility>

#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

// Typographic marks and what they stand for.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> marks = {{
    {"\u2019", "'"},
    {"\u2018", "'"},
    {"\u201c", " "},
    {"\u201d", " "},
    {"\u2013", "-"},
    {"\u2014", ","},
    {"\u00d7", " x "},
    {"\u00b2", "2"},
    {"\u2033", " inch "},
    {"\u2032", " feet "},
    {"\u00a0", " "},
    {"\u3002", "."},
}};

std::string plain(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    bool found = false;
    for (const auto& [mark, meaning] : marks)
      if (text.substr(i).starts_with(mark)) {
        result += meaning;
        i += mark.size();
        found = true;
        break;
      }
    if (!found) result += text[i++];
  }
  return lower(result);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) > 127;
}

class Splitter {
 public:
  explicit Splitter(std::string text) : text_(std::move(text)) {}

  std::vector<Token> run() {
    while (at_ < text_.size() && tokens_.size() < max_tokens) {
      const char c = text_[at_];
      if (is_digit(c))
        number();
      else if (is_letter(c))
        word();
      else
        mark();
    }
    return std::move(tokens_);
  }

 private:
  char next(std::size_t ahead = 1) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  // No locale, no exponents: digits, a point, digits.
  void number() {
    const std::size_t start = at_;
    double value = 0.0, place = 1.0;
    while (at_ < text_.size() && is_digit(text_[at_])) value = value * 10.0 + (text_[at_++] - '0');
    if (at_ < text_.size() && text_[at_] == '.' && is_digit(next())) {
      ++at_;
      while (at_ < text_.size() && is_digit(text_[at_]))
        value += (text_[at_++] - '0') * (place *= 0.1);
    }
    tokens_.push_back({Token::Kind::number, text_.substr(start, at_ - start), value});
    if (at_ < text_.size() && text_[at_] == '\'') {
      tokens_.push_back({Token::Kind::word, "feet", 0.0});
      ++at_;
    }
  }

  void word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    // "m2" and "ft2" are words.
    if (at_ < text_.size() && text_[at_] == '2' && !is_digit(next()) && !is_letter(next())) ++at_;
    std::string text = text_.substr(start, at_ - start);
    if (at_ < text_.size() && text_[at_] == '\'') apostrophe(text);
    tokens_.push_back({Token::Kind::word, std::move(text), 0.0});
  }

  // "kid's" and "kids'" lose the ending, "don't" becomes one word.
  void apostrophe(std::string& text) {
    ++at_;
    std::string ending;
    while (at_ < text_.size() && is_letter(text_[at_])) ending += text_[at_++];
    if (ending != "s") text += ending;
  }

  void mark() {
    const char c = text_[at_++];
    // A point inside a word or before a digit is no end.
    if (c == '.' || c == '!' || c == '?' || c == ';' || c == '\n' || c == ':')
      tokens_.push_back({Token::Kind::stop, ".", 0.0});
    else if (c == ',' || c == '(' || c == ')')
      tokens_.push_back({Token::Kind::comma, ",", 0.0});
    else if (c == '&' || c == '+')
      tokens_.push_back({Token::Kind::word, "and", 0.0});
  }

  std::string text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text) {
  return Splitter(plain(text)).run();
}

}  // namespace roomgen::design
