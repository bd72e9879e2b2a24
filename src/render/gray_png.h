#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::detail {

/// A PNG of one channel of 16 bits; rows from the top.
Result<std::string> encode_gray_png(const std::vector<std::uint16_t>& values, int width, int height);

}  // namespace roomgen::detail
