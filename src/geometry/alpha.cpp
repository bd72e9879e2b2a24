#include "alpha.h"

namespace roomgen {

namespace {

// Among texels that are not opaque, how many may be half-way for the texture to count as a mask:
// outlines of leaves are smoothed.
constexpr double soft_share_of_mask = 0.5;
constexpr double soft_share_of_image = 0.02;

AlphaMode alpha_mode(const Image& image) {
  std::size_t hollow = 0, soft = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    const auto alpha = image.pixels[i];
    hollow += alpha < 250;
    soft += alpha > 25 && alpha < 230;
  }
  if (hollow == 0) return AlphaMode::opaque;
  const auto share = [&](std::size_t whole) {
    return static_cast<double>(soft) / static_cast<double>(whole);
  };
  const bool mostly_hard =
      share(hollow) < soft_share_of_mask || share(image.pixels.size() / 4) < soft_share_of_image;
  return mostly_hard ? AlphaMode::mask : AlphaMode::blend;
}

}  // namespace

AlphaMode alpha_mode(const Material& material) {
  if (material.transparent()) return AlphaMode::blend;
  return material.texture ? alpha_mode(*material.texture) : AlphaMode::opaque;
}

}  // namespace roomgen
