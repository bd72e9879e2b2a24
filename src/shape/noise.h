#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "roomgen/geometry/model.h"

namespace roomgen::shape {

using Tint = Eigen::Vector3d;

// Inline, all of this: an image calls it a million times.

/// What is left of the next whole number below; for numbers as small as coordinates of images.
inline double fraction(double x) {
  const double whole = static_cast<double>(static_cast<std::int64_t>(x));
  return x - (whole > x ? whole - 1.0 : whole);
}

/// 0 below `low`, 1 above `high`, smooth between.
inline double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Value noise in [0, 1) over the unit square that repeats after it: 1 unit is one image.
class Noise {
 public:
  Noise(int columns, int rows, std::uint64_t seed);
  double operator()(double u, double v) const {
    const double x = fraction(u) * columns_, y = fraction(v) * rows_;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double fx = eased(x - column), fy = eased(y - row);
    const double* above = &values_[static_cast<std::size_t>(row * stride() + column)];
    const double* below = above + stride();
    const double low = above[0] + fx * (above[1] - above[0]);
    const double high = below[0] + fx * (below[1] - below[0]);
    return low + fy * (high - low);
  }

 private:
  static double eased(double t) { return t * t * (3.0 - 2.0 * t); }
  int stride() const { return columns_ + 2; }

  int columns_, rows_;
  /// Begins again after the last column and row, and once more for fractions rounded up to 1.
  std::vector<double> values_;
};

/// Three octaves of noise, the finer the fainter, in [0, 1).
class Clouds {
 public:
  Clouds(int columns, int rows, std::uint64_t seed);
  double operator()(double u, double v) const {
    return (4.0 * broad_(u, v) + 2.0 * middle_(u, v) + fine_(u, v)) / 7.0;
  }

 private:
  Noise broad_, middle_, fine_;
};

inline Tint mixed(const Tint& a, const Tint& b, double t) {
  return a + t * (b - a);
}

/// An opaque image of what `color` (0 to 255) gives at (u, v), both in (0, 1), v downwards.
template <typename Color>
Image painted(int width, int height, const Color& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Tint rgb = color((x + 0.5) / width, (y + 0.5) / height);
      std::uint8_t* pixel = image.at(x, y);
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(std::clamp(rgb[k], 0.0, 255.0) + 0.5);
      pixel[3] = 255;
    }
  return image;
}

}  // namespace roomgen::shape
