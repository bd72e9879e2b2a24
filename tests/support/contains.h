#pragma once

#include <string_view>

/// Is `part` somewhere in `text`?
inline bool contains_text(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// One line for people: not empty, no line break.
inline bool is_one_line(std::string_view text) {
  return !text.empty() && text.find('\n') == std::string_view::npos;
}
