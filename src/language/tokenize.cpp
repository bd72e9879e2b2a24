#include <array>
#include <utility>

#include "token.h"

namespace roomgen::language {

namespace {

// What a character means, whatever script and style it is written in.
enum class Sign {
  letter,
  digit,
  space,
  apostrophe,
  quote,
  hyphen,
  dash,
  comma,
  stop,
  open,
  close,
  feet,
  inches,
  times,
  fraction,
  squared,
  symbol
};

struct Character {
  Sign sign = Sign::symbol;
  std::size_t length = 1;
  char letter = '\0';  ///< of an ASCII letter or digit, in lower case
  double value = 0.0;  ///< of a fraction
};

struct Mark {
  std::string_view text;
  Sign sign;
  double value = 0.0;
};

constexpr std::array<Mark, 24> marks = {{
    {"\u2019", Sign::apostrophe},     {"\u2018", Sign::apostrophe},
    {"\u201c", Sign::quote},          {"\u201d", Sign::quote},
    {"\u201e", Sign::quote},          {"\u00ab", Sign::quote},
    {"\u00bb", Sign::quote},          {"\u2010", Sign::hyphen},
    {"\u2011", Sign::hyphen},         {"\u2013", Sign::dash},
    {"\u2014", Sign::dash},           {"\u2026", Sign::stop},
    {"\u3002", Sign::stop},           {"\u2022", Sign::stop},
    {"\u00a0", Sign::space},          {"\u202f", Sign::space},
    {"\u2032", Sign::feet},           {"\u2033", Sign::inches},
    {"\u00d7", Sign::times},          {"\u00b2", Sign::squared},
    {"\u00bd", Sign::fraction, 0.5},  {"\u00bc", Sign::fraction, 0.25},
    {"\u00be", Sign::fraction, 0.75}, {"\u3001", Sign::comma},
}};

Sign sign_of(char c) {
  switch (c) {
    case ' ':
    case '\t':
    case '\r':
    case '\f':
    case '\v':
      return Sign::space;
    case '\'':
    case '`':
      return Sign::apostrophe;
    case '"':
      return Sign::quote;
    case '-':
      return Sign::hyphen;
    case ',':
      return Sign::comma;
    case '.':
    case '!':
    case '?':
    case ';':
    case ':':
    case '\n':
      return Sign::stop;
    case '(':
    case '[':
    case '{':
      return Sign::open;
    case ')':
    case ']':
    case '}':
      return Sign::close;
    default:
      return Sign::symbol;
  }
}

Character character_at(std::string_view text, std::size_t at) {
  if (at >= text.size()) return {Sign::space, 0};
  const char c = text[at];
  if (c >= '0' && c <= '9') return {Sign::digit, 1, c};
  if (c >= 'a' && c <= 'z') return {Sign::letter, 1, c};
  if (c >= 'A' && c <= 'Z') return {Sign::letter, 1, static_cast<char>(c - 'A' + 'a')};
  if (static_cast<unsigned char>(c) < 128) return {sign_of(c), 1};
  for (const auto& mark : marks)
    if (text.substr(at).starts_with(mark.text))
      return {mark.sign, mark.text.size(), '\0', mark.value};
  return {Sign::letter, 1};
}

// Lower case also for the capitals of Western Europe, U+00C0 to U+00DE.
void append_lower(std::string& to, std::string_view text, std::size_t at,
                  const Character& character) {
  if (character.letter) {
    to += character.letter;
    return;
  }
  const auto byte = static_cast<unsigned char>(text[at]);
  const bool capital = at > 0 && static_cast<unsigned char>(text[at - 1]) == 0xC3 && byte >= 0x80 &&
                       byte <= 0x9E && byte != 0x97;
  to += static_cast<char>(capital ? byte + 0x20 : byte);
}

class Splitter {
 public:
  Splitter(std::string_view text, std::size_t most) : text_(text), most_(most) {}

  std::vector<Token> run() {
    while (at_ < text_.size() && tokens_.size() < most_) {
      const Character c = character_at(text_, at_);
      if (c.sign == Sign::space) {
        skip(c);
      } else if (c.sign == Sign::digit || c.sign == Sign::fraction) {
        number();
      } else if (c.sign == Sign::letter) {
        word();
      } else {
        mark(c);
      }
    }
    return std::move(tokens_);
  }

 private:
  Character here(std::size_t ahead = 0) const { return character_at(text_, at_ + ahead); }
  bool is(Sign sign, std::size_t ahead = 0) const { return here(ahead).sign == sign; }

  void skip(const Character& c) {
    at_ += c.length;
    joint_ = Token::Joint::apart;
  }

  Token& add(Token::Kind kind, std::size_t begin, std::string text) {
    Token token;
    token.kind = kind;
    token.joint = tokens_.empty() ? Token::Joint::apart : joint_;
    token.span = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    token.text = std::move(text);
    tokens_.push_back(std::move(token));
    joint_ = Token::Joint::none;
    return tokens_.back();
  }

  // Digits, groups of three parted by commas, decimals behind a point or a comma, a fraction.
  void number() {
    const std::size_t begin = at_;
    double value = 0.0;
    while (is(Sign::digit) || is_group()) {
      if (!is(Sign::digit)) ++at_;
      value = value * 10.0 + (text_[at_++] - '0');
    }
    if (at_ > begin && (text(at_) == '.' || is_decimal_comma()) && is(Sign::digit, 1)) {
      ++at_;
      for (double place = 0.1; is(Sign::digit); place *= 0.1) value += (text_[at_++] - '0') * place;
    }
    if (const Character fraction = here(); fraction.sign == Sign::fraction) {
      value += fraction.value;
      at_ += fraction.length;
    }
    if (at_ > begin && is_ending("st", "nd", "rd", "th")) {
      at_ += 2;
      add(Token::Kind::ordinal, begin, std::string(text_.substr(begin, at_ - begin))).value = value;
    } else if (at_ > begin && is_ending("s")) {
      ++at_;
      add(Token::Kind::word, begin, std::string(text_.substr(begin, at_ - begin)));
    } else {
      add(Token::Kind::number, begin, std::string(text_.substr(begin, at_ - begin))).value = value;
      length_mark();
    }
  }

  char text(std::size_t at) const { return at < text_.size() ? text_[at] : '\0'; }

  // "1,200": three digits and no fourth.
  bool is_group() const {
    return text(at_) == ',' && is(Sign::digit, 1) && is(Sign::digit, 2) && is(Sign::digit, 3) &&
           !is(Sign::digit, 4) && at_ > 0 && text(at_ - 1) >= '0' && text(at_ - 1) <= '9';
  }
  // "2,5 m": what is no list has no spaces.
  bool is_decimal_comma() const {
    return text(at_) == ',' && is(Sign::digit, 1) && !(is(Sign::digit, 2) && is(Sign::digit, 3));
  }

  template <typename... Endings>
  bool is_ending(Endings... endings) const {
    const auto fits = [&](std::string_view ending) {
      for (std::size_t i = 0; i < ending.size(); ++i)
        if (here(i).letter != ending[i]) return false;
      return !is(Sign::letter, ending.size()) && !is(Sign::digit, ending.size());
    };
    return (fits(endings) || ...);
  }

  // 6'2", 5′
  void length_mark() {
    const Character c = here();
    const std::size_t begin = at_;
    const bool feet = c.sign == Sign::feet ||
                      (c.sign == Sign::apostrophe && !is_open_ && !is(Sign::letter, c.length));
    const bool inches = c.sign == Sign::inches || (c.sign == Sign::quote && !is_open_);
    if (!feet && !inches) return;
    at_ += c.length;
    add(Token::Kind::word, begin, feet ? "ft" : "in");
  }

  void word() {
    const std::size_t begin = at_;
    std::string text;
    bool is_full = false;
    while (is(Sign::letter)) {
      const std::size_t longest = longest_word + (is_within_character() ? 3 : 0);
      is_full = is_full || text.size() >= longest;
      if (!is_full) append_lower(text, text_, at_, here());
      ++at_;
    }
    // "m2" and "m²" are words.
    const bool square = (text == "m" || text == "ft" || text == "cm") &&
                        (is(Sign::squared) ||
                         (this->text(at_) == '2' && !is(Sign::digit, 1) && !is(Sign::letter, 1)));
    if (square) {
      text += '2';
      at_ += here().length;
    }
    // "w/ chair"
    if (text == "w" && this->text(at_) == '/') {
      text = "with";
      ++at_;
    }
    if (text == "x" && multiplies(begin)) return;
    std::string clitic = clitic_behind(text);
    if (is_abbreviated(text)) ++at_;
    add(Token::Kind::word, begin, std::move(text)).clitic = std::move(clitic);
  }

  bool is_within_character() const { return (static_cast<unsigned char>(text_[at_]) & 0xC0u) == 0x80u; }

  // "kid's", "kids'", "there's", "don't": what follows the word.
  std::string clitic_behind(std::string& text) {
    const Character c = here();
    if (c.sign != Sign::apostrophe) return "";
    std::string clitic = "'";
    std::size_t end = c.length;
    for (; is(Sign::letter, end); ++end) append_lower(clitic, text_, at_ + end, here(end));
    const bool possessive = clitic == "'" && text.ends_with('s') && !is_single_open_;
    if (clitic == "'" && !possessive) return "";
    at_ += end;
    if (clitic == "'t" && text.ends_with('n') && text.size() > 1) {
      text.pop_back();
      clitic = "n't";
    }
    return clitic;
  }

  bool is_behind(Token::Kind kind) const {
    return !tokens_.empty() && tokens_.back().kind == kind && joint_ == Token::Joint::none;
  }
  // The "x" of "2x chair" says nothing; "chair x2" is "chair (2)". True if it was either.
  bool multiplies(std::size_t begin) {
    if (is_behind(Token::Kind::number) && is(Sign::space) && is(Sign::letter, 1)) return true;
    const bool is_number_behind = !tokens_.empty() && tokens_.back().kind == Token::Kind::word &&
                                  joint_ == Token::Joint::apart && is(Sign::digit);
    if (is_number_behind) add(Token::Kind::open, begin, "x");
    return is_number_behind;
  }

  // The point of "approx." or "sq." ends nothing.
  bool is_abbreviated(std::string_view text) const {
    if (this->text(at_) != '.') return false;
    for (const std::string_view known :
         {"approx", "sq", "ca", "incl", "e", "g", "i", "vs", "max", "min"})
      if (text == known) return at_ + 1 < text_.size() && text_[at_ + 1] != '\n';
    return false;
  }

  void mark(const Character& c) {
    const std::size_t begin = at_;
    at_ += c.length;
    const std::string written(text_.substr(begin, c.length));
    switch (c.sign) {
      case Sign::hyphen:
        if (joint_ == Token::Joint::none && (is(Sign::letter) || is(Sign::digit)))
          joint_ = Token::Joint::hyphen;
        else
          add(Token::Kind::symbol, begin, "-");
        return;
      case Sign::dash:
        add(joint_ == Token::Joint::none && is(Sign::digit) ? Token::Kind::symbol
                                                            : Token::Kind::comma,
            begin, "-");
        return;
      case Sign::comma:
        add(Token::Kind::comma, begin, ",");
        return;
      case Sign::stop:
        add(Token::Kind::stop, begin, written);
        return;
      case Sign::open:
        add(Token::Kind::open, begin, written);
        return;
      case Sign::close:
        add(Token::Kind::close, begin, written);
        return;
      case Sign::times:
        if (!multiplies(begin)) add(Token::Kind::word, begin, "x");
        return;
      case Sign::quote:
        is_open_ = !is_open_;
        add(Token::Kind::quote, begin, "\"");
        return;
      case Sign::apostrophe:
        is_single_open_ = joint_ == Token::Joint::apart;
        add(Token::Kind::quote, begin, "'");
        return;
      default:
        if (written == "+" && is_behind(Token::Kind::number) && is(Sign::space))  // "3+ chairs"
          return static_cast<void>(add(Token::Kind::symbol, begin, written));
        add(written == "&" || written == "+" ? Token::Kind::word : Token::Kind::symbol, begin,
            written == "&" || written == "+" ? "and" : written);
    }
  }

  std::string_view text_;
  std::size_t most_, at_ = 0;
  std::vector<Token> tokens_;
  Token::Joint joint_ = Token::Joint::apart;
  bool is_open_ = false;         ///< within double quotes
  bool is_single_open_ = false;  ///< within single ones
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, std::size_t most) {
  return Splitter(text, most).run();
}

}  // namespace roomgen::language
