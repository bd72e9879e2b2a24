#pragma once

#include <optional>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen::cli {

/// "4x5", "4 x 5", "4.2x3.6": width and depth in metres. Empty text gives nothing.
Result<std::optional<Vec2>> parse_size(const std::string& text);

}  // namespace roomgen::cli
