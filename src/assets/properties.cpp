#include "properties.h"

#include <charconv>
#include <cstdint>

#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace {

constexpr std::size_t most_properties = 2'000'000;  // a hundred for each model of a catalogue

void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | (code >> 6));
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | (code >> 12));
    put(0x80 | ((code >> 6) & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | (code >> 18));
    put(0x80 | ((code >> 12) & 0x3F));
    put(0x80 | ((code >> 6) & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

// The four hexadecimal digits of a \u escape at `at`, or nothing usable (-1).
std::int32_t hex4(std::string_view text, std::size_t at) {
  if (at + 4 > text.size()) return -1;
  std::int32_t code = 0;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + at + 4, code, 16);
  return error == std::errc{} && end == text.data() + at + 4 ? code : -1;
}

bool is_high_surrogate(std::int32_t code) {
  return code >= 0xD800 && code < 0xDC00;
}
bool is_low_surrogate(std::int32_t code) {
  return code >= 0xDC00 && code < 0xE000;
}

std::string unescape(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '\\' || i + 1 == text.size()) {
      append_utf8(result, static_cast<unsigned char>(c));
      continue;
    }
    const char escaped = text[++i];
    if (escaped == 'n')
      result += '\n';
    else if (escaped == 't')
      result += '\t';
    else if (escaped == 'r' || escaped == 'f')
      result += ' ';
    else if (std::int32_t code; escaped == 'u' && (code = hex4(text, i + 1)) >= 0) {
      i += 4;
      const std::int32_t low =
          i + 2 < text.size() && text[i + 1] == '\\' && text[i + 2] == 'u' ? hex4(text, i + 3) : -1;
      if (is_high_surrogate(code) && is_low_surrogate(low)) {
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        i += 6;
      }
      // Half a pair cannot be written as UTF-8.
      if (!is_high_surrogate(code) && !is_low_surrogate(code))
        append_utf8(result, static_cast<std::uint32_t>(code));
    } else {
      append_utf8(result, static_cast<unsigned char>(escaped));
    }
  }
  return result;
}

bool ends_in_continuation(std::string_view line) {
  std::size_t slashes = 0;
  while (slashes < line.size() && line[line.size() - 1 - slashes] == '\\') ++slashes;
  return slashes % 2 == 1;
}

std::string_view take_line(std::string_view& text) {
  const auto end = text.find_first_of("\r\n");
  const auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

// Where the key ends: at the first '=', ':' or white space that is not escaped.
std::size_t key_length(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\')
      ++i;
    else if (std::string_view("=: \t\f").find(line[i]) != std::string_view::npos)
      return i;
  }
  return line.size();
}

}  // namespace

Result<std::map<std::string, std::string, std::less<>>> parse_properties(std::string_view latin1) {
  std::map<std::string, std::string, std::less<>> result;
  while (!latin1.empty()) {
    std::string line(trim(take_line(latin1)));
    if (line.empty() || line.front() == '#' || line.front() == '!') continue;
    // What was joined ends in no lone backslash, so the line that came last decides.
    for (bool goes_on = ends_in_continuation(line); goes_on && !latin1.empty();) {
      const auto next = trim(take_line(latin1));
      goes_on = ends_in_continuation(next);
      line.pop_back();
      line += next;
    }
    const std::string_view view = line;
    const auto length = key_length(view);
    std::string_view value = trim(view.substr(length));
    if (!value.empty() && (value.front() == '=' || value.front() == ':'))
      value = trim(value.substr(1));
    result[unescape(view.substr(0, length))] = unescape(value);
    if (result.size() > most_properties)
      return Error{Error::Kind::limit, "more than " + std::to_string(most_properties) + " properties"};
  }
  return result;
}

}  // namespace roomgen::assets
