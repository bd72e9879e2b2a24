#include <algorithm>
#include <cmath>

#include "texture_painter.h"

namespace roomgen::detail {

namespace {

/// The grain of boards: every one is cut from another place and has a tone of its own.
class Grain {
 public:
  Grain(const Rgb& tone, float contrast) : tone_(tone), contrast_(contrast) {}

  /// u runs along the board.
  Rgb color(float u, float v, int board) const {
    u += hash(board, 11, 4);
    v += hash(board, 13, 5);
    const float grain = 0.55f * broad_.at(u, v) + 0.45f * fine_.at(u, v);
    const float shade = 1.0f + contrast_ * (hash(board, 3, 2) - 0.5f);
    const float warmth = 0.03f * (hash(board, 5, 3) - 0.5f);
    Rgb color = tone_ * (shade * (0.90f + 0.13f * grain + 0.07f * cloud_.at(u, v)));
    color.x() *= 1.0f + warmth;
    color.z() *= 1.0f - warmth;
    return color;
  }

 private:
  Rgb tone_;
  float contrast_;  ///< between boards
  Noise broad_{7, 150, 51}, fine_{22, 310, 52}, cloud_{5, 24, 53};
};

// Boards run along u, two to a row, each row shifted.
class Boards : public Painter {
 public:
  struct Style {
    float joint;     ///< half width of the gap, in parts of a board's width
    float darkness;  ///< of the gap, 1 is black
    float contrast;  ///< between boards
  };
  Boards(const Rgb& tone, const Style& style) : grain_(tone, style.contrast), style_(style) {}

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
    return grain_.color(u, v, board) * (1.0f - style_.darkness * gap);
  }

 private:
  static constexpr float rows = 16;

  Grain grain_;
  Style style_;
};

// Boards stand along v, with a groove whose one side is lit.
class Panels : public Painter {
 public:
  explicit Panels(const Rgb& tone) : grain_(tone, 0.07f) {}

  Rgb color(float u, float v) const override {
    const float position = u * columns;
    const int board = static_cast<int>(position);
    const float across = position - static_cast<float>(board);
    const float groove = std::clamp(1.6f - across / 0.022f, 0.0f, 1.0f);
    const float lit = std::clamp(1.0f - std::abs(across - 0.065f) / 0.02f, 0.0f, 1.0f);
    return grain_.color(v, u, board) * (1.0f - 0.45f * groove + 0.06f * lit);
  }

 private:
  static constexpr float columns = 16;
  Grain grain_;
};

// Blocks of 1 x 4 cells. Each row of cells is the one above shifted by a cell, so that lying and
// standing blocks interlock; the pattern repeats after eight cells in both directions.
class Herringbone : public Painter {
 public:
  explicit Herringbone(const Rgb& tone) : grain_(tone, 0.16f) {}

  Rgb color(float u, float v) const override {
    const int column = static_cast<int>(u * cells), row = static_cast<int>(v * cells);
    const float x = u * cells - static_cast<float>(column), y = v * cells - static_cast<float>(row);
    const int phase = ((column - row) % period + period) % period;
    const bool lies = phase < length;
    // Where the block begins, and how far along and across it the point lies, in cells.
    const int step = lies ? phase : 2 * length - 1 - phase;
    const int first_column = lies ? column - step : column;
    const int first_row = lies ? row : row - step;
    const float along = static_cast<float>(step) + (lies ? x : y), across = lies ? y : x;
    const int board = wrapped(first_column) * 64 + wrapped(first_row) * 2 + (lies ? 1 : 0);
    const float edge =
        std::min(std::min(across, 1.0f - across), std::min(along, length - along)) / 0.035f;
    const float gap = std::clamp(1.5f - edge, 0.0f, 1.0f);
    return (lies ? grain_.color(u, v, board) : grain_.color(v, u, board)) * (1.0f - 0.38f * gap);
  }

 private:
  static constexpr int length = 4, period = 2 * length;
  static constexpr int cells = 16;

  static int wrapped(int cell) { return (cell % cells + cells) % cells; }

  Grain grain_;
};

}  // namespace

std::unique_ptr<Painter> wood_painter(TexturePattern pattern, const Rgb& tone) {
  switch (pattern) {
    case TexturePattern::planks:
      return std::make_unique<Boards>(tone, Boards::Style{0.022f, 0.42f, 0.15f});
    case TexturePattern::decking:
      return std::make_unique<Boards>(tone, Boards::Style{0.045f, 0.70f, 0.14f});
    case TexturePattern::panels:
      return std::make_unique<Panels>(tone);
    case TexturePattern::herringbone:
      return std::make_unique<Herringbone>(tone);
    default:
      return nullptr;
  }
}

}  // namespace roomgen::detail
