#pragma once

#include <string_view>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

namespace roomgen::decode {

/// Decodes PNG or JPEG bytes (told apart by their first bytes), at most 16384 pixels a side, and
/// shrinks the picture by averaging until no side is longer than `max_side`.
Result<Image> decode_image(std::string_view bytes, int max_side);

}  // namespace roomgen::decode
