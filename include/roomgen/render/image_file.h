#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "roomgen/base/file.h"
#include "roomgen/base/result.h"
#include "roomgen/export/exporter.h"
#include "roomgen/geometry/model.h"

namespace roomgen {

/// Largest picture that is read, pixels.
inline constexpr std::size_t max_image_pixels = 64u << 20;

/// PNG (ISO/IEC 15948): RGB if the picture is opaque, else RGBA. `effort` is zlib's level, 0 to 9.
Result<std::string> encode_png(const Image& image, int effort = 3);
/// Baseline JPEG of an opaque picture; quality 1 to 100.
Result<std::string> encode_jpeg(const Image& image, int quality = 90);
/// An ImageEncoder for exporters: JPEG for opaque textures, PNG for small ones and those with
/// alpha.
Result<EncodedImage> encode_texture(const Image& image);
/// Any PNG, as 8-bit RGBA.
Result<Image> decode_png(std::string_view bytes);

Status write_png(const std::filesystem::path& path, const Image& image);
/// The same into a folder of results; `name` is relative to it.
Status write_png(const OutputFolder& folder, const std::filesystem::path& name, const Image& image);
Result<Image> read_png(const std::filesystem::path& path);

}  // namespace roomgen
