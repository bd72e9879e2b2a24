#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "texture.h"

namespace roomgen::detail {

using Rgb = Eigen::Vector3f;

/// An integer hash with good avalanche (the finaliser of MurmurHash3), as a number in [0, 1).
inline float hash(int x, int y, int salt) {
  auto h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^
           static_cast<std::uint32_t>(y) * 0x85ebca77u ^
           static_cast<std::uint32_t>(salt) * 0xc2b2ae3du;
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) / 16777216.0f;
}

/// Value noise in [0, 1) that repeats after one image.
class Noise {
 public:
  Noise(int periods_u, int periods_v, int salt) : columns_(periods_u), rows_(periods_v) {
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) values_.push_back(hash(x, y, salt));
  }

  /// u and v count images and are not negative.
  float at(float u, float v) const {
    const float x = u * static_cast<float>(columns_), y = v * static_cast<float>(rows_);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const float fx = smooth(x - static_cast<float>(x0)), fy = smooth(y - static_cast<float>(y0));
    const int left = x0 % columns_, right = (x0 + 1) % columns_;
    const float* above = &values_[static_cast<std::size_t>(y0 % rows_ * columns_)];
    const float* below = &values_[static_cast<std::size_t>((y0 + 1) % rows_ * columns_)];
    const float low = above[left] + fx * (above[right] - above[left]);
    const float high = below[left] + fx * (below[right] - below[left]);
    return low + fy * (high - low);
  }

 private:
  static float smooth(float t) { return t * t * (3.0f - 2.0f * t); }

  int columns_, rows_;
  std::vector<float> values_;
};

/// The colour at (u, v), both in [0, 1).
class Painter {
 public:
  virtual ~Painter() = default;
  virtual Rgb color(float u, float v) const = 0;
};

// Each returns nothing for patterns that are not its own.
std::unique_ptr<Painter> wood_painter(TexturePattern pattern, const Rgb& tone);
std::unique_ptr<Painter> masonry_painter(TexturePattern pattern, const Rgb& tone,
                                         const Rgb& second);
std::unique_ptr<Painter> plain_painter(TexturePattern pattern, const Rgb& tone);
std::unique_ptr<Painter> wallpaper_painter(TexturePattern pattern, const Rgb& tone,
                                           const Rgb& second);

}  // namespace roomgen::detail
