#include <algorithm>
#include <cmath>

#include "texture_painter.h"

namespace roomgen::detail {

namespace {

// Printed paper: a ground, a figure over it and a hint of fibre.
class Wallpaper : public Painter {
 public:
  Wallpaper(const Rgb& ground, const Rgb& figure) : ground_(ground), figure_(figure) {}

  Rgb color(float u, float v) const final {
    const float ink = std::clamp(coverage(u, v), 0.0f, 1.0f);
    return (0.99f + 0.02f * fibre_.at(u, v)) * ((1.0f - ink) * ground_ + ink * figure_);
  }

 protected:
  /// How much of the figure's ink lies here, 0 to 1.
  virtual float coverage(float u, float v) const = 0;

 private:
  Rgb ground_, figure_;
  Noise fibre_{160, 220, 91};
};

class Stripes : public Wallpaper {
 public:
  using Wallpaper::Wallpaper;

 protected:
  float coverage(float u, float) const override {
    const float x = u * pairs - std::floor(u * pairs);
    // Half of each pair, with soft edges.
    return std::clamp((0.25f - std::abs(x - 0.5f)) / 0.008f + 0.5f, 0.0f, 1.0f);
  }

 private:
  static constexpr float pairs = 4;
};

/// A point in its cell of a staggered grid, from the cell's middle, in parts of its side.
Eigen::Vector2f in_staggered_cell(float u, float v, int count) {
  const float y = v * static_cast<float>(count);
  const int row = static_cast<int>(y);
  const float x = u * static_cast<float>(count) + (row % 2 ? 0.5f : 0.0f);
  return {x - std::floor(x) - 0.5f, y - static_cast<float>(row) - 0.5f};
}

class Dots : public Wallpaper {
 public:
  using Wallpaper::Wallpaper;

 protected:
  float coverage(float u, float v) const override {
    return (0.2f - in_staggered_cell(u, v, 4).norm()) / 0.02f + 0.5f;
  }
};

// A stem with three pairs of leaves and a bud.
class Sprigs : public Wallpaper {
 public:
  using Wallpaper::Wallpaper;

 protected:
  float coverage(float u, float v) const override {
    Eigen::Vector2f p = in_staggered_cell(u, v, 4);
    float ink = (0.012f - std::abs(p.x())) / 0.01f + 0.5f;
    if (std::abs(p.y()) > 0.34f) ink = 0.0f;
    ink = std::max(ink, (0.055f - (p - Eigen::Vector2f(0.0f, -0.36f)).norm()) / 0.015f + 0.5f);
    p.x() = std::abs(p.x());  // leaves come in pairs
    for (int pair = 0; pair < 3; ++pair) {
      const Eigen::Vector2f d =
          p - Eigen::Vector2f(0.11f, -0.14f + 0.19f * static_cast<float>(pair));
      // Along and across a leaf that rises outwards.
      const float along = 0.8f * d.x() - 0.6f * d.y(), across = 0.6f * d.x() + 0.8f * d.y();
      const float shape =
          std::sqrt(along * along / (0.12f * 0.12f) + across * across / (0.045f * 0.045f));
      ink = std::max(ink, (1.0f - shape) / 0.2f + 0.5f);
    }
    return ink;
  }
};

}  // namespace

std::unique_ptr<Painter> wallpaper_painter(TexturePattern pattern, const Rgb& tone,
                                           const Rgb& second) {
  switch (pattern) {
    case TexturePattern::stripes:
      return std::make_unique<Stripes>(tone, second);
    case TexturePattern::dots:
      return std::make_unique<Dots>(tone, second);
    case TexturePattern::sprigs:
      return std::make_unique<Sprigs>(tone, second);
    default:
      return nullptr;
  }
}

}  // namespace roomgen::detail
