#include "texture.h"

#include <algorithm>
#include <cmath>

#include "texture_painter.h"

namespace roomgen {

namespace {

using detail::Painter;
using detail::Rgb;

struct PatternFacts {
  TexturePattern pattern;
  std::string_view name;
  double extent;  ///< metres
  bool two_tones;
};

constexpr PatternFacts facts[] = {
    {TexturePattern::planks, "planks", 2.4, false},
    {TexturePattern::decking, "decking", 2.4, false},
    {TexturePattern::herringbone, "herringbone", 1.2, false},
    {TexturePattern::panels, "panels", 1.92, false},
    {TexturePattern::tiles, "tiles", 1.2, false},
    {TexturePattern::subway, "subway", 0.8, false},
    {TexturePattern::checkerboard, "checkerboard", 1.2, true},
    {TexturePattern::stone, "stone", 2.4, false},
    {TexturePattern::bricks, "bricks", 2.0, false},
    {TexturePattern::carpet, "carpet", 1.0, false},
    {TexturePattern::concrete, "concrete", 2.4, false},
    {TexturePattern::stripes, "stripes", 0.6, true},
    {TexturePattern::dots, "dots", 0.6, true},
    {TexturePattern::sprigs, "sprigs", 0.8, true},
};

const PatternFacts& facts_of(TexturePattern pattern) {
  for (const auto& entry : facts)
    if (entry.pattern == pattern) return entry;
  return facts[0];
}

std::unique_ptr<Painter> make_painter(TexturePattern pattern, const Rgb& tone, const Rgb& second) {
  if (auto painter = detail::wood_painter(pattern, tone)) return painter;
  if (auto painter = detail::masonry_painter(pattern, tone, second)) return painter;
  if (auto painter = detail::wallpaper_painter(pattern, tone, second)) return painter;
  return detail::plain_painter(pattern, tone);
}

}  // namespace

double texture_extent(TexturePattern pattern) {
  return facts_of(pattern).extent;
}

bool has_two_tones(TexturePattern pattern) {
  return facts_of(pattern).two_tones;
}

std::string_view name(TexturePattern pattern) {
  return facts_of(pattern).name;
}

std::optional<TexturePattern> parse_texture_pattern(std::string_view name) {
  for (const auto& entry : facts)
    if (entry.name == name) return entry.pattern;
  return std::nullopt;
}

const std::vector<TexturePattern>& all_texture_patterns() {
  static const auto all = [] {
    std::vector<TexturePattern> patterns;
    for (const auto& entry : facts) patterns.push_back(entry.pattern);
    return patterns;
  }();
  return all;
}

Image paint_texture(TexturePattern pattern, const Eigen::Vector3f& tone,
                    const Eigen::Vector3f& second) {
  constexpr int side = 512;
  const auto painter = make_painter(pattern, tone, second);
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
