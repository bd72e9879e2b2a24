#pragma once

#include <string>
#include <string_view>

namespace roomgen::create {

/// What a description says is printed, painted or written on a thing.
struct Print {
  std::string motif;    ///< a name of data/motifs.json; empty: none was named
  std::string palette;  ///< by words of style: "ink"
  std::string words;    ///< in quotes, or after "says" and the like; may be of several lines
};

/// Words in lines of about ten letters, as posters have them.
std::string in_lines(std::string_view words);

Print print_in(std::string_view description);
}  // namespace roomgen::create
