#include "layer_pictures.h"

#include <array>
#include <cmath>

#include "gray_png.h"
#include "roomgen/render/pictures.h"

namespace roomgen::detail {

namespace {

constexpr double most_millimetres = 65535.0;

std::vector<std::uint16_t> millimetres(const std::vector<float>& metres) {
  std::vector<std::uint16_t> result;
  for (const float depth : metres) {
    const double value = std::isfinite(depth) ? std::clamp(1000.0 * depth, 1.0, most_millimetres) : 0.0;
    result.push_back(static_cast<std::uint16_t>(std::lround(value)));
  }
  return result;
}

Image normal_picture(const Layers& layers) {
  return picture_of_pixels(layers, [&](std::size_t i) {
    std::array<std::uint8_t, 3> color{};
    for (int axis = 0; axis < 3; ++axis)
      color[static_cast<std::size_t>(axis)] =
          static_cast<std::uint8_t>(std::lround(127.5f + 127.0f * layers.normals[i][axis]));
    return color;
  });
}

Result<std::string> encode_gray(const Layers& layers, const std::vector<std::uint16_t>& values) {
  return encode_gray_png(values, layers.camera.width, layers.camera.height);
}

}  // namespace

Result<std::string> encode_depths(const Layers& layers) { return encode_gray(layers, millimetres(layers.depths)); }
Result<std::string> encode_normals(const Layers& layers) { return encode_png(normal_picture(layers), 1); }
Result<std::string> encode_instances(const Layers& layers) { return encode_gray(layers, layers.objects); }
Result<std::string> encode_categories(const Layers& layers) { return encode_gray(layers, layers.categories); }

}  // namespace roomgen::detail
