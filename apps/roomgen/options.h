#pragma once

#include <string>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen::cli {

/// "4x5", "4.2 x 3.6": width and depth in metres.
Result<Vec2> parse_size(const std::string& text);

}  // namespace roomgen::cli
