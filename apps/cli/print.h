#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen::cli {

/// On stdout, one a line. Names and words may be anybody's: nothing in them steers the terminal.
inline void print_lines(const std::vector<std::string>& lines) {
  for (const auto& line : lines) std::printf("%s\n", printable(line).c_str());
}

/// What people should know besides the answer.
inline void warn(std::string_view text) { std::fprintf(stderr, "roomgen: %s\n", printable(text).c_str()); }

}  // namespace roomgen::cli
