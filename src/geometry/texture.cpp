#include "roomgen/geometry/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace roomgen {

namespace {

using Rgb = Eigen::Vector3f;

// An integer hash with good avalanche (the finaliser of MurmurHash3), as a number in [0, 1).
float hash(int x, int y, int salt) {
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

// Value noise in [0, 1) that repeats after one image.
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

// The colour at (u, v), both in [0, 1).
class Painter {
 public:
  virtual ~Painter() = default;
  virtual Rgb color(float u, float v) const = 0;
};

// Boards run along u, two to a row, each row shifted and every board of its own tone and grain.
class Boards : public Painter {
 public:
  struct Style {
    float joint;     ///< half width of the gap, in parts of a board's width
    float darkness;  ///< of the gap, 1 is black
    float contrast;  ///< between boards
  };
  Boards(const Rgb& tone, const Style& style) : tone_(tone), style_(style) {}

  Rgb color(float u, float v) const override {
    const float position = v * rows;
    const int row = static_cast<int>(position);
    const float across = position - static_cast<float>(row);
    const float along = 2.0f * u + hash(row, 7, 1);
    const int board = row * 2 + static_cast<int>(along) % 2;
    const float end = along - std::floor(along);

    const float from_edge = std::min(across, 1.0f - across) / style_.joint;
    const float from_end = std::min(end, 1.0f - end) * 8.0f / style_.joint;
    const float gap = std::clamp(1.5f - std::min(from_edge, from_end), 0.0f, 1.0f);
    return wood(u + hash(board, 11, 4), v + hash(board, 13, 5), board) *
           (1.0f - style_.darkness * gap);
  }

 private:
  static constexpr float rows = 16;

  Rgb wood(float u, float v, int board) const {
    const float grain = 0.55f * broad_.at(u, v) + 0.45f * fine_.at(u, v);
    const float shade = 1.0f + style_.contrast * (hash(board, 3, 2) - 0.5f);
    const float warmth = 0.03f * (hash(board, 5, 3) - 0.5f);
    Rgb color = tone_ * (shade * (0.90f + 0.13f * grain + 0.07f * cloud_.at(u, v)));
    color.x() *= 1.0f + warmth;
    color.z() *= 1.0f - warmth;
    return color;
  }

  Rgb tone_;
  Style style_;
  Noise broad_{7, 150, 51}, fine_{22, 310, 52}, cloud_{5, 24, 53};
};

class Tiles : public Painter {
 public:
  Tiles(const Rgb& tone, bool veined) : tone_(tone), veined_(veined) {}

  Rgb color(float u, float v) const override {
    const int column = static_cast<int>(u * count), row = static_cast<int>(v * count);
    const float x = u * count - static_cast<float>(column), y = v * count - static_cast<float>(row);
    float shade = 1.0f + 0.045f * (hash(column, row, 21) - 0.5f) + 0.03f * (cloud_.at(u, v) - 0.5f);
    if (veined_) shade -= 0.10f * vein(u, v, hash(column, row, 23));
    const float edge = std::min({x, 1.0f - x, y, 1.0f - y});
    const float grout_width = veined_ ? 0.004f : 0.010f;
    const float grout = std::clamp(2.0f - edge / grout_width, 0.0f, 1.0f);
    return ((1.0f - grout) * shade + grout * 0.80f) * tone_;
  }

 private:
  static constexpr float count = 4;

  // 1 in the middle of a vein, 0 beside it. Every slab is cut from another place.
  float vein(float u, float v, float shift) const {
    const float bend =
        broad_.at(u + shift, v) + 0.5f * middle_.at(u, v + shift) + 0.25f * fine_.at(u, v);
    return std::max(0.0f, 1.0f - 9.0f * std::abs(std::fmod(3.0f * bend + shift, 1.0f) - 0.5f));
  }

  Rgb tone_;
  bool veined_;
  Noise cloud_{16, 16, 22}, broad_{6, 6, 24}, middle_{13, 13, 25}, fine_{29, 29, 26};
};

class Carpet : public Painter {
 public:
  explicit Carpet(const Rgb& tone) : tone_(tone) {}
  Rgb color(float u, float v) const override {
    return tone_ *
           (0.90f + 0.11f * fibre_.at(u, v) + 0.06f * tuft_.at(u, v) + 0.04f * wear_.at(u, v));
  }

 private:
  Rgb tone_;
  Noise fibre_{200, 200, 31}, tuft_{90, 90, 32}, wear_{5, 5, 33};
};

class Concrete : public Painter {
 public:
  explicit Concrete(const Rgb& tone) : tone_(tone) {}
  Rgb color(float u, float v) const override {
    const float cloud = 0.6f * broad_.at(u, v) + 0.4f * middle_.at(u, v);
    return tone_ * (0.95f + 0.08f * cloud + 0.03f * grit_.at(u, v));
  }

 private:
  Rgb tone_;
  Noise broad_{4, 4, 41}, middle_{11, 11, 42}, grit_{140, 140, 43};
};

std::unique_ptr<Painter> make_painter(TexturePattern pattern, const Rgb& tone) {
  switch (pattern) {
    case TexturePattern::planks:
      return std::make_unique<Boards>(tone, Boards::Style{0.022f, 0.42f, 0.15f});
    case TexturePattern::decking:
      return std::make_unique<Boards>(tone, Boards::Style{0.045f, 0.70f, 0.14f});
    case TexturePattern::tiles:
      return std::make_unique<Tiles>(tone, false);
    case TexturePattern::stone:
      return std::make_unique<Tiles>(tone, true);
    case TexturePattern::carpet:
      return std::make_unique<Carpet>(tone);
    case TexturePattern::concrete:
      return std::make_unique<Concrete>(tone);
  }
  return std::make_unique<Concrete>(tone);
}

}  // namespace

double texture_extent(TexturePattern pattern) {
  switch (pattern) {
    case TexturePattern::planks:
    case TexturePattern::decking:
    case TexturePattern::stone:
    case TexturePattern::concrete:
      return 2.4;
    case TexturePattern::tiles:
      return 1.2;
    case TexturePattern::carpet:
      return 1.0;
  }
  return 1.0;
}

Image paint_texture(TexturePattern pattern, const Eigen::Vector3f& tone) {
  constexpr int side = 512;
  const auto painter = make_painter(pattern, tone);
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / side,
                  v = (static_cast<float>(y) + 0.5f) / side;
      const Rgb color = painter->color(u, v);
      std::uint8_t* pixel = image.at(x, y);
      for (int channel = 0; channel < 3; ++channel)
        pixel[channel] =
            static_cast<std::uint8_t>(std::lround(std::clamp(color[channel], 0.0f, 255.0f)));
      pixel[3] = 255;
    }
  return image;
}

}  // namespace roomgen
