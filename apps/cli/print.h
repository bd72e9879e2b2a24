#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen::cli {

/// Names and words may be anybody's: nothing in them steers the terminal, or begins a line as if it were the program's.
inline std::string one_line(std::string text) {
  std::replace_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
  return printable(text);
}

/// On stdout, one a line.
inline void print_lines(const std::vector<std::string>& lines) {
  for (const auto& line : lines) std::printf("%s\n", one_line(line).c_str());
}

/// What people should know besides the answer.
inline void warn(std::string_view text) { std::fprintf(stderr, "roomgen: %s\n", one_line(std::string(text)).c_str()); }

}  // namespace roomgen::cli
