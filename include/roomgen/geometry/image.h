#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace roomgen {

/// 8-bit RGBA pixels, sRGB, rows from the top, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 4 * width * height bytes

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(4 * static_cast<std::size_t>(w) * h) {}

  bool empty() const { return pixels.empty(); }
  std::uint8_t* at(int x, int y) { return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
  const std::uint8_t* at(int x, int y) const {
    return pixels.data() + 4 * (static_cast<std::size_t>(y) * width + x);
  }
};

inline bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4)
    if (image.pixels[i] != 255) return false;
  return true;
}

}  // namespace roomgen
