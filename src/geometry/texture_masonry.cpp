#include <algorithm>
#include <cmath>

#include "texture_painter.h"

namespace roomgen::detail {

namespace {

/// Where a point lies in a grid of `columns` x `rows` stones, every other row shifted by `shift`
/// stones.
struct Course {
  int column, row;
  float edge_u, edge_v;  ///< distance from the nearer edge, in parts of a stone's length and height

  Course(float u, float v, int columns, int rows, float shift) {
    const float y = v * static_cast<float>(rows);
    row = static_cast<int>(y);
    const float x = u * static_cast<float>(columns) + (row % 2 ? shift : 0.0f);
    column = static_cast<int>(x) % columns;
    const float along = x - std::floor(x), up = y - static_cast<float>(row);
    edge_u = std::min(along, 1.0f - along);
    edge_v = std::min(up, 1.0f - up);
  }
};

class Tiles : public Painter {
 public:
  Tiles(const Rgb& tone, bool veined) : tone_(tone), veined_(veined) {}

  Rgb color(float u, float v) const override {
    const Course at(u, v, count, count, 0.0f);
    float shade =
        1.0f + 0.045f * (hash(at.column, at.row, 21) - 0.5f) + 0.03f * (cloud_.at(u, v) - 0.5f);
    if (veined_) shade -= 0.10f * vein(u, v, hash(at.column, at.row, 23));
    const float grout_width = veined_ ? 0.004f : 0.010f;
    const float grout = std::clamp(2.0f - std::min(at.edge_u, at.edge_v) / grout_width, 0.0f, 1.0f);
    return ((1.0f - grout) * shade + grout * 0.80f) * tone_;
  }

 private:
  static constexpr int count = 4;

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

class Checkerboard : public Painter {
 public:
  Checkerboard(const Rgb& tone, const Rgb& second) : tones_{tone, second} {}

  Rgb color(float u, float v) const override {
    const Course at(u, v, count, count, 0.0f);
    const Rgb& tone = tones_[(at.column + at.row) % 2];
    const float shade =
        1.0f + 0.04f * (hash(at.column, at.row, 61) - 0.5f) + 0.06f * (cloud_.at(u, v) - 0.5f);
    const float grout = std::clamp(2.0f - std::min(at.edge_u, at.edge_v) / 0.006f, 0.0f, 1.0f);
    const Rgb joint = 0.42f * (tones_[0] + tones_[1]);
    return (1.0f - grout) * shade * tone + grout * joint;
  }

 private:
  static constexpr int count = 4;
  Rgb tones_[2];
  Noise cloud_{14, 14, 62};
};

// Glazed, with an edge that catches the light.
class Subway : public Painter {
 public:
  Subway(const Rgb& tone, const Rgb& joint) : tone_(tone), joint_(joint) {}

  Rgb color(float u, float v) const override {
    const Course at(u, v, columns, rows, 0.5f);
    // A tile is twice as long as high: both distances in parts of its height.
    const float edge = std::min(2.0f * at.edge_u, at.edge_v);
    const float shade = 1.0f + 0.03f * (hash(at.column, at.row, 71) - 0.5f);
    const float rim = std::clamp(1.0f - std::abs(edge - 0.06f) / 0.03f, 0.0f, 1.0f);
    const float grout = std::clamp(2.0f - edge / 0.016f, 0.0f, 1.0f);
    return (1.0f - grout) * (shade + 0.03f * rim) * tone_ + grout * joint_;
  }

 private:
  static constexpr int columns = 4, rows = 8;
  Rgb tone_, joint_;
};

class Bricks : public Painter {
 public:
  Bricks(const Rgb& tone, const Rgb& joint) : tone_(tone), joint_(joint) {}

  Rgb color(float u, float v) const override {
    // Edges are not quite straight.
    const Course at(u, std::min(v + 0.002f * wobble_.at(u, v), 0.9999f), columns, rows, 0.5f);
    const float edge = std::min(3.0f * at.edge_u, at.edge_v) - 0.05f * rough_.at(u, v);
    const float mortar = std::clamp((0.085f - edge) / 0.035f, 0.0f, 1.0f);
    const float shade = 0.93f + 0.14f * hash(at.column, at.row, 81) +
                        0.14f * (rough_.at(u, v) - 0.5f) + 0.10f * (grit_.at(u, v) - 0.5f);
    // The lower edge of a joint lies in shadow.
    const float hollow = 1.0f - 0.12f * mortar;
    return hollow *
           ((1.0f - mortar) * shade * tone_ + mortar * (0.94f + 0.12f * grit_.at(u, v)) * joint_);
  }

 private:
  static constexpr int columns = 8, rows = 24;
  Rgb tone_, joint_;
  Noise wobble_{31, 43, 82}, rough_{121, 133, 83}, grit_{230, 230, 84};
};

}  // namespace

std::unique_ptr<Painter> masonry_painter(TexturePattern pattern, const Rgb& tone,
                                         const Rgb& second) {
  switch (pattern) {
    case TexturePattern::tiles:
      return std::make_unique<Tiles>(tone, false);
    case TexturePattern::stone:
      return std::make_unique<Tiles>(tone, true);
    case TexturePattern::checkerboard:
      return std::make_unique<Checkerboard>(tone, second);
    case TexturePattern::subway:
      return std::make_unique<Subway>(tone, second);
    case TexturePattern::bricks:
      return std::make_unique<Bricks>(tone, second);
    default:
      return nullptr;
  }
}

}  // namespace roomgen::detail
