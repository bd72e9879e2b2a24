#include "loose_parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr int max_depth = 32;
constexpr std::size_t max_members = 500;  ///< of one object: looking up a key is linear
constexpr std::string_view fence = "```";

struct Quote {
  std::string_view mark;
  char family;  ///< a string ends with any mark of the family that it began with
};

constexpr std::array quotes = {Quote{"\"", '"'},     Quote{"\u201c", '"'}, Quote{"\u201d", '"'},
                               Quote{"\u201e", '"'}, Quote{"'", '\''},     Quote{"\u2018", '\''},
                               Quote{"\u2019", '\''}};

const Quote* quote_at(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(std::min(at, text.size()));
  for (const auto& quote : quotes)
    if (rest.starts_with(quote.mark)) return &quote;
  return nullptr;
}

enum class Literal { null, yes, no };

struct LiteralWord {
  std::string_view word;
  Literal meaning;
};

constexpr std::array literals = {
    LiteralWord{"null", Literal::null},     LiteralWord{"None", Literal::null},
    LiteralWord{"none", Literal::null},     LiteralWord{"undefined", Literal::null},
    LiteralWord{"NaN", Literal::null},      LiteralWord{"nan", Literal::null},
    LiteralWord{"Infinity", Literal::null}, LiteralWord{"-Infinity", Literal::null},
    LiteralWord{"inf", Literal::null},      LiteralWord{"-inf", Literal::null},
    LiteralWord{"true", Literal::yes},      LiteralWord{"True", Literal::yes},
    LiteralWord{"TRUE", Literal::yes},      LiteralWord{"false", Literal::no},
    LiteralWord{"False", Literal::no},      LiteralWord{"FALSE", Literal::no}};

Json literal_value(Literal literal) {
  return literal == Literal::null ? Json(nullptr) : Json(literal == Literal::yes);
}

bool is_strict(std::string_view word) {
  return word == "null" || word == "true" || word == "false";
}

std::optional<Json> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const char* end = text.data() + text.size();
  long long integer = 0;
  if (const auto read = std::from_chars(text.data(), end, integer);
      read.ec == std::errc{} && read.ptr == end)
    return Json(integer);
  double real = 0;
  const auto read = std::from_chars(text.data(), end, real);
  if (read.ptr != end || text.empty()) return std::nullopt;
  if (read.ec != std::errc{} || !std::isfinite(real)) return Json(nullptr);
  return Json(real);
}

bool is_key_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '$';
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

void append_utf8(std::string& out, unsigned code) {
  const auto byte = [&](unsigned value) { out += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6));
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3F));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

}  // namespace

void LooseParser::note(const char* what) {
  if (std::find(repairs_.begin(), repairs_.end(), what) == repairs_.end())
    repairs_.emplace_back(what);
}

bool LooseParser::at_end() const {
  return at_ >= text_.size() || text_.substr(at_).starts_with(fence);
}

bool LooseParser::skip_comment() {
  const std::string_view rest = text_.substr(std::min(at_, text_.size()));
  const bool line = rest.starts_with("//") || rest.starts_with('#');
  if (!line && !rest.starts_with("/*")) return false;
  const auto end = line ? text_.find('\n', at_) : text_.find("*/", at_ + 2);
  at_ = end == std::string_view::npos ? text_.size() : end + (line ? 1 : 2);
  note("comments were dropped");
  return true;
}

void LooseParser::skip_space() {
  do {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  } while (skip_comment());
}

std::optional<Json> LooseParser::value(int depth) {
  if (depth > max_depth) return std::nullopt;
  const char c = peek();
  if (c == '{') return object(depth);
  if (c == '[' || c == '(') return array(depth);
  if (!quote_at(text_, at_)) return bare();
  auto text = string();
  return text ? std::optional<Json>(*std::move(text)) : std::nullopt;
}

// Goes to the next item of a list and past separators and the end of the list.
LooseParser::Next LooseParser::next_item(char closing) {
  for (int commas = 0;; ++at_) {
    skip_space();
    if (at_end()) {
      truncated_ = true;
      note("the answer ended too early; open brackets were closed");
      return Next::end;
    }
    const char c = peek();
    if (c == ',' || c == ';') {
      if (++commas > 1) note("superfluous commas were dropped");
      continue;
    }
    if (c == closing) {
      if (commas > 0) note("superfluous commas were dropped");
      ++at_;
      return Next::end;
    }
    // The end of an outer list: this one was not closed.
    if (c == '}') {
      note("a missing bracket was added");
      return Next::end;
    }
    if (c != ']' && c != ')') return Next::item;
    note("a bracket of the wrong kind was replaced");
    if (closing == '}') continue;
    ++at_;
    return Next::end;
  }
}

std::optional<Json> LooseParser::object(int depth) {
  Json members = Json::object();
  ++at_;
  while (true) {
    const Next next = next_item('}');
    if (next == Next::end) return members;
    if (peek() == '{' || peek() == '[' || peek() == '(') return std::nullopt;
    auto name = key();
    if (!name) {
      if (truncated_) continue;
      skip_prose();
      continue;
    }
    if (at_end()) continue;  // a key without its value
    auto member = value(depth + 1);
    if (!member) {
      if (!truncated_) return std::nullopt;
      continue;
    }
    if (members.size() >= max_members) return std::nullopt;
    members[*name] = *std::move(member);
  }
}

std::optional<Json> LooseParser::array(int depth) {
  if (peek() == '(') note("round brackets were read as square ones");
  const char closing = peek() == '(' ? ')' : ']';
  Json elements = Json::array();
  ++at_;
  while (next_item(closing) == Next::item) {
    auto element = value(depth + 1);
    if (element)
      elements.push_back(*std::move(element));
    else if (!truncated_)
      return std::nullopt;
  }
  return elements;
}

// A key and its colon; nothing if what stands there is none.
std::optional<std::string> LooseParser::key() {
  std::string name;
  if (quote_at(text_, at_)) {
    auto quoted = string();
    if (!quoted) return std::nullopt;
    name = *std::move(quoted);
  } else {
    while (is_key_char(peek())) name += text_[at_++];
    if (name.empty()) return std::nullopt;
    note("keys without quotes were accepted");
  }
  skip_space();
  if (peek() == ':' || peek() == '=') {
    if (peek() == '=') note("\"=\" was read as a colon");
    ++at_;
    skip_space();
    return name;
  }
  return std::nullopt;
}

// What stands where a key should be and is none.
void LooseParser::skip_prose() {
  note("words between the values were dropped");
  const auto stop = text_.find_first_of(",}{\n", at_);
  at_ = stop == std::string_view::npos ? text_.size() : stop;
}

// A quotation mark ends its string where the text goes on as JSON; others belong to the string.
bool LooseParser::ends_string(std::size_t after) const {
  bool newline = false;
  for (; after < text_.size() && is_space(text_[after]); ++after) newline |= text_[after] == '\n';
  if (after >= text_.size()) return true;
  if (std::string_view(",:;}])=").find(text_[after]) != std::string_view::npos) return true;
  const std::string_view rest = text_.substr(after);
  if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with(fence)) return true;
  return newline && (quote_at(text_, after) || is_key_char(text_[after]));
}

std::optional<std::string> LooseParser::string() {
  const Quote* opening = quote_at(text_, at_);
  if (opening->mark != "\"") note("quotation marks were replaced");
  at_ += opening->mark.size();
  std::string out;
  while (at_ < text_.size()) {
    if (text_[at_] == '\\') {
      append_escape(out);
      continue;
    }
    const Quote* quote = quote_at(text_, at_);
    if (quote && quote->family == opening->family) {
      at_ += quote->mark.size();
      if (ends_string(at_)) return out;
      if (quote->family == '"') note("quotation marks inside a text were kept");
      out += quote->mark;
      continue;
    }
    out += text_[at_++];
  }
  truncated_ = true;
  note("the answer ended inside a text, which was dropped");
  return std::nullopt;
}

std::optional<unsigned> LooseParser::hex_digits() {
  unsigned code = 0;
  const std::string_view digits = text_.substr(std::min(at_, text_.size()), 4);
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  if (digits.size() < 4 || read.ptr != digits.data() + 4) return std::nullopt;
  at_ += 4;
  return code;
}

void LooseParser::append_escape(std::string& out) {
  ++at_;
  const char c = peek();
  if (at_ < text_.size()) ++at_;
  constexpr std::string_view letters = "nrtbf", meanings = "\n\r\t\b\f";
  if (const auto known = letters.find(c); c != '\0' && known != std::string_view::npos) {
    out += meanings[known];
    return;
  }
  if (c != 'u') {
    if (c != '\0') out += c;
    return;
  }
  auto code = hex_digits();
  if (code && *code >= 0xD800 && *code < 0xDC00 && text_.substr(at_).starts_with("\\u")) {
    at_ += 2;
    const auto low = hex_digits();
    code = low && *low >= 0xDC00 && *low < 0xE000
               ? std::optional(0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00))
               : std::nullopt;
  }
  const bool character = code && *code != 0 && (*code < 0xD800 || *code >= 0xE000);
  append_utf8(out, character ? *code : static_cast<unsigned>('?'));
}

// A number, a literal, or words without quotation marks up to where the list goes on.
Json LooseParser::bare() {
  const std::size_t begin = at_;
  while (at_ < text_.size() &&
         std::string_view(",]})\n\r;").find(text_[at_]) == std::string_view::npos) {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with(fence)) break;
    // "near(bed-0)": a bracket inside the words.
    if (text_[at_] == '(') {
      const auto close = rest.substr(0, 80).find(')');
      if (close != std::string_view::npos) at_ += close;
    }
    ++at_;
  }
  const std::string_view word = trim(text_.substr(begin, at_ - begin));
  for (const auto& literal : literals)
    if (literal.word == word) {
      if (!is_strict(word)) note("literals of another language were replaced");
      return literal_value(literal.meaning);
    }
  if (auto value = number(word)) {
    if (value->is_null()) note("a number out of range was dropped");
    return *std::move(value);
  }
  note("words without quotation marks were read as a text");
  return std::string(word);
}

}  // namespace roomgen
