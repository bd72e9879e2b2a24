#pragma once

#include <algorithm>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/view/view.h"

namespace roomgen::detail {

/// An opaque picture; `color_of` gives the three components of a pixel by its index.
template <typename ColorOf>
Image picture_of_pixels(const Layers& layers, const ColorOf& color_of) {
  Image image(layers.camera.width, layers.camera.height);
  for (std::size_t i = 0; i < layers.objects.size(); ++i) {
    const auto color = color_of(i);
    std::copy(color.begin(), color.end(), &image.pixels[4 * i]);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

// Layers as PNG files (docs/layers.md).
Result<std::string> encode_depths(const Layers& layers);
Result<std::string> encode_normals(const Layers& layers);
Result<std::string> encode_instances(const Layers& layers);
Result<std::string> encode_categories(const Layers& layers);

}  // namespace roomgen::detail
