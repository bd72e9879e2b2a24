#include "obj_numbers.h"

#include <algorithm>

namespace roomgen::decode {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// v, vt, vn, vp: names in other lines may have such words.
bool is_of_vertices(std::string_view line) {
  const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
  return begin != line.end() && *begin == 'v';
}

void append(std::string& text, std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '.' && i > 0 && is_blank(line[i - 1]) && i + 1 < line.size() &&
        is_digit(line[i + 1]))
      text += '0';
    text += line[i];
  }
}

// A backslash at its end goes on with the line on the next one.
bool goes_on(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line.ends_with('\\');
}

}  // namespace

std::string with_leading_zeros(std::string_view obj) {
  std::string text;
  text.reserve(obj.size() + obj.size() / 8);
  bool vertices = false, continued = false;
  while (!obj.empty()) {
    const std::size_t end = std::min(obj.find('\n'), obj.size());
    const std::string_view line = obj.substr(0, end);
    if (!continued) vertices = is_of_vertices(line);
    if (vertices) append(text, line);
    else text += line;
    if (end < obj.size()) text += '\n';
    continued = goes_on(line);
    obj.remove_prefix(std::min(end + 1, obj.size()));
  }
  return text;
}

}  // namespace roomgen::decode
