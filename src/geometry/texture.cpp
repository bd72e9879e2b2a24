#include "roomgen/geometry/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace roomgen {

namespace {

using Rgb = Eigen::Vector3f;

// An integer hash with good avalanche (the finaliser of MurmurHash3), as a number in [0, 1).
float hash(int x, int y, int salt) {
  auto h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^
           static_cast<std::uint32_t>(salt) * 0xc2b2ae3du;
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) / 16777216.0f;
}

int wrap(int value, int period) {
  const int rest = value % period;
  return rest < 0 ? rest + period : rest;
}

// Value noise in [0, 1) that repeats after `periods` lattice cells; u and v are in [0, 1).
float noise(float u, float v, int periods_u, int periods_v, int salt) {
  const float x = u * static_cast<float>(periods_u), y = v * static_cast<float>(periods_v);
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const float sx = fx * fx * (3.0f - 2.0f * fx), sy = fy * fy * (3.0f - 2.0f * fy);
  const auto at = [&](int i, int j) {
    return hash(wrap(x0 + i, periods_u), wrap(y0 + j, periods_v), salt);
  };
  const float low = at(0, 0) + sx * (at(1, 0) - at(0, 0));
  const float high = at(0, 1) + sx * (at(1, 1) - at(0, 1));
  return low + sy * (high - low);
}

struct Boards {
  int rows;
  float joint;     ///< half width of the gap, in parts of a board's width
  float darkness;  ///< of the gap, 1 is black
  float contrast;  ///< between boards
};

// Boards run along u, two to a row, each row shifted and every board of its own tone and grain.
Rgb board_color(float u, float v, const Rgb& tone, const Boards& boards) {
  const float row_position = v * static_cast<float>(boards.rows);
  const int row = static_cast<int>(row_position);
  const float across = row_position - static_cast<float>(row);
  const float along = 2.0f * u + hash(row, 7, 1);
  const int board = wrap(static_cast<int>(std::floor(along)), 2);
  const int id = row * 2 + board;

  const float shade = 1.0f + boards.contrast * (hash(id, 3, 2) - 0.5f);
  const float warmth = 0.03f * (hash(id, 5, 3) - 0.5f);
  const float shift = hash(id, 11, 4);
  const float grain = 0.55f * noise(u + shift, v, 7, 150, 5 + id) +
                      0.45f * noise(u + shift, v, 22, 310, 45 + id);
  const float cloud = noise(u + shift, v + shift, 5, 24, 90 + id);
  Rgb color = tone * (shade * (0.90f + 0.13f * grain + 0.07f * cloud));
  color.x() *= 1.0f + warmth;
  color.z() *= 1.0f - warmth;

  const float end = along - std::floor(along);
  const float from_edge = std::min(across, 1.0f - across) / boards.joint;
  const float from_end = std::min(end, 1.0f - end) * 8.0f / boards.joint;
  const float gap = std::clamp(1.5f - std::min(from_edge, from_end), 0.0f, 1.0f);
  return color * (1.0f - boards.darkness * gap);
}

Rgb tile_color(float u, float v, const Rgb& tone, int count, bool veined) {
  const float n = static_cast<float>(count);
  const int column = static_cast<int>(u * n), row = static_cast<int>(v * n);
  const float x = u * n - static_cast<float>(column), y = v * n - static_cast<float>(row);
  float shade = 1.0f + 0.045f * (hash(column, row, 21) - 0.5f) +
                0.03f * (noise(u, v, 16, 16, 22) - 0.5f);
  if (veined) {
    const float shift = hash(column, row, 23);
    const float bend = noise(u + shift, v, 6, 6, 24) + 0.5f * noise(u, v + shift, 13, 13, 25) +
                       0.25f * noise(u, v, 29, 29, 26);
    const float vein = std::abs(std::fmod(3.0f * bend + shift, 1.0f) - 0.5f);
    shade -= 0.10f * std::max(0.0f, 1.0f - 9.0f * vein);
  }
  const float edge = std::min({x, 1.0f - x, y, 1.0f - y});
  const float grout_width = veined ? 0.004f : 0.010f;
  const float grout = std::clamp(2.0f - edge / grout_width, 0.0f, 1.0f);
  const Rgb grout_color = tone * 0.80f;
  return (1.0f - grout) * shade * tone + grout * grout_color;
}

Rgb carpet_color(float u, float v, const Rgb& tone) {
  const float fibre = noise(u, v, 200, 200, 31), tuft = noise(u, v, 90, 90, 32);
  const float wear = noise(u, v, 5, 5, 33);
  return tone * (0.90f + 0.11f * fibre + 0.06f * tuft + 0.04f * wear);
}

Rgb concrete_color(float u, float v, const Rgb& tone) {
  const float cloud = 0.6f * noise(u, v, 4, 4, 41) + 0.4f * noise(u, v, 11, 11, 42);
  const float grit = noise(u, v, 140, 140, 43);
  return tone * (0.95f + 0.08f * cloud + 0.03f * grit);
}

Rgb color_at(TexturePattern pattern, float u, float v, const Rgb& tone) {
  switch (pattern) {
    case TexturePattern::planks: return board_color(u, v, tone, {16, 0.022f, 0.50f, 0.20f});
    case TexturePattern::decking: return board_color(u, v, tone, {16, 0.045f, 0.75f, 0.16f});
    case TexturePattern::tiles: return tile_color(u, v, tone, 4, false);
    case TexturePattern::stone: return tile_color(u, v, tone, 4, true);
    case TexturePattern::carpet: return carpet_color(u, v, tone);
    case TexturePattern::concrete: return concrete_color(u, v, tone);
  }
  return tone;
}

}  // namespace

double texture_extent(TexturePattern pattern) {
  switch (pattern) {
    case TexturePattern::planks:
    case TexturePattern::decking:
    case TexturePattern::stone:
    case TexturePattern::concrete: return 2.4;
    case TexturePattern::tiles: return 1.2;
    case TexturePattern::carpet: return 1.0;
  }
  return 1.0;
}

Image paint_texture(TexturePattern pattern, const Eigen::Vector3f& tone) {
  constexpr int side = 512;
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / side, v = (static_cast<float>(y) + 0.5f) / side;
      const Rgb color = color_at(pattern, u, v, tone);
      std::uint8_t* pixel = image.at(x, y);
      for (int channel = 0; channel < 3; ++channel)
        pixel[channel] =
            static_cast<std::uint8_t>(std::lround(std::clamp(color[channel], 0.0f, 255.0f)));
      pixel[3] = 255;
    }
  return image;
}

}  // namespace roomgen
