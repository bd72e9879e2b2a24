#pragma once

#include <algorithm>
#include <cmath>

namespace roomgen::detail {

/// The pixel that a coordinate falls into; what is far beyond any picture ends a million pixels off, what is no number is 0.
inline int pixel_at(double coordinate) {
  constexpr double far = 1e6;
  return std::isnan(coordinate) ? 0 : static_cast<int>(std::floor(std::clamp(coordinate, -far, far)));
}

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  PixelRect grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  PixelRect clipped(const PixelRect& other) const {
    return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
            std::min(y1, other.y1)};
  }
  bool meets(const PixelRect& other) const { return !clipped(other).empty(); }
  void cover(const PixelRect& other) {
    if (empty())
      *this = other;
    else if (!other.empty())
      *this = {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1),
               std::max(y1, other.y1)};
  }
};

}  // namespace roomgen::detail
