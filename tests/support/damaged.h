#pragma once

#include <string>

#include "base/random.h"

/// The text with one to eight damages: up to `longest` bytes dropped (only while more than `least`
/// are left) or said twice, or any byte put in.
inline std::string damaged(std::string text, roomgen::Random& random, int longest,
                           std::size_t least = 0) {
  for (int n = random.integer(1, 8); n > 0 && !text.empty(); --n) {
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
    const auto length = static_cast<std::size_t>(random.integer(1, longest));
    const int how = random.integer(0, 2);
    if (how == 0 && text.size() > least)
      text.erase(at, length);
    else if (how == 1)
      text.insert(at, 1, static_cast<char>(random.integer(0, 255)));
    else
      text.insert(at, text.substr(at, length));
  }
  return text;
}
