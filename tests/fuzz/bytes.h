#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// What a fuzz target is given. The first byte may choose between readers, so that one target serves several of a kind.
struct FuzzedBytes {
  const std::uint8_t* data;
  std::size_t size;

  std::string_view text() const { return {reinterpret_cast<const char*>(data), size}; }
  /// Below `count`; takes the first byte off.
  std::size_t choice(std::size_t count) {
    if (size == 0) return 0;
    --size;
    return *data++ % count;
  }
};

/// What must hold of whatever was read.
inline void must(bool holds) {
  if (!holds) __builtin_trap();
}
