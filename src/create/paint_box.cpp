#include "paint_box.h"

#include <algorithm>
#include <cmath>

#include "geometry/texture.h"
#include "shape/pattern.h"

namespace roomgen::create {

namespace {

constexpr float least_shade = 0.55f, most_shade = 1.3f;  // of the drawing that a texture keeps
constexpr float least_luma = 8.0f;                       // of a texture whose drawing can be seen
constexpr std::size_t most_toned = 64;                   // they are as large as photographs

float luma(const Tone& tone) { return tone.dot(Tone(0.299f, 0.587f, 0.114f)); }

int rounded_part(float component) { return static_cast<int>(std::lround(component)); }

auto pair_of(const Tone& a, const Tone& b) {
  return std::make_tuple(rounded_part(a[0]), rounded_part(a[1]), rounded_part(a[2]), rounded_part(b[0]), rounded_part(b[1]), rounded_part(b[2]));
}

Image retoned(const Image& image, const Tone& tone) {
  const float mean = std::max(luma(mean_of(image)), least_luma);
  Image result = image;
  for (std::size_t i = 0; i + 3 < result.pixels.size(); i += 4) {
    std::uint8_t* pixel = result.pixels.data() + i;
    const float shade = std::clamp(luma(Tone(pixel[0], pixel[1], pixel[2])) / mean, least_shade, most_shade);
    for (int c = 0; c < 3; ++c)
      pixel[c] = static_cast<std::uint8_t>(std::clamp(tone[c] * shade, 0.0f, 255.0f));
  }
  return result;
}

}  // namespace

Tone mean_of(const Image& image) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const std::size_t count = image.pixels.size() / 4;
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < 3; ++c) sum[c] += image.pixels[4 * i + static_cast<std::size_t>(c)];
  return (sum / static_cast<double>(std::max<std::size_t>(count, 1))).cast<float>();
}

PaintBox::Drawing PaintBox::drawing(const std::string& name, double scale, const Tone& first, const Tone& second) {
  const auto texture = parse_texture_pattern(name);
  const auto pattern = shape::pattern_named(name);
  const bool is_shape = pattern != shape::Pattern::none || !texture;
  auto& image = drawings_[{name, pair_of(first, second)}];
  if (!image)
    image = std::make_shared<const Image>(is_shape ? shape::paint_pattern(pattern, first, second, 0)
                                                   : paint_texture(*texture, first, second));
  return {image, scale * (is_shape ? shape::pattern_extent(pattern) : texture_extent(*texture))};
}

std::shared_ptr<const Image> PaintBox::toned(const std::shared_ptr<const Image>& image, const Tone& tone) {
  if (toned_.size() >= most_toned) toned_.clear();
  auto& result = toned_[{image, pair_of(tone, Tone::Zero())}];
  if (!result) result = std::make_shared<const Image>(retoned(*image, tone));
  return result;
}

}  // namespace roomgen::create
