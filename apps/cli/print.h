#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace roomgen::cli {

/// On stdout, one a line.
inline void print_lines(const std::vector<std::string>& lines) {
  for (const auto& line : lines) std::printf("%s\n", line.c_str());
}

/// What people should know besides the answer.
inline void warn(const std::string& text) { std::fprintf(stderr, "roomgen: %s\n", text.c_str()); }

}  // namespace roomgen::cli
