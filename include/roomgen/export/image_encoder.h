#pragma once

#include <functional>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/geometry/image.h"

namespace roomgen {

/// A picture as the bytes of a file.
struct EncodedImage {
  std::string mime_type;  ///< "image/png" or "image/jpeg"
  std::string bytes;
};

/// How exporters make files of textures. The core links no image library: roomgen::render provides
/// one (render/image_file.h).
using ImageEncoder = std::function<Result<EncodedImage>(const Image&)>;

}  // namespace roomgen
