#include <algorithm>

#include "roomgen/render/pictures.h"

namespace roomgen {

namespace {

// Below this many pixels JPEG saves nothing worth its blur.
constexpr std::size_t small_texture = 64 * 64;

}  // namespace

Result<EncodedImage> encode_texture(const Image& image) {
  const bool is_png = image.pixels.size() / 4 <= small_texture || !is_opaque(image);
  auto bytes = is_png ? encode_png(image) : encode_jpeg(image);
  if (!bytes) return bytes.error();
  return EncodedImage{is_png ? "image/png" : "image/jpeg", std::move(*bytes)};
}

}  // namespace roomgen
