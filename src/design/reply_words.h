#pragma once

#include <algorithm>
#include <span>
#include <string>

namespace roomgen::design {

/// Whether a word of an answer is one of a list of words.
inline bool is_one_of(const std::string& word, std::span<const char* const> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace roomgen::design
