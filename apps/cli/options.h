#pragma once

#include <cstdint>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen::cli {

/// The largest seed that a JSON file holds exactly (2^53 - 1).
inline constexpr std::uint64_t max_seed = 9007199254740991;

/// "4x5", "4.2 x 3.6": width and depth in metres.
Result<Vec2> parse_size(const std::string& text);
/// "0.4x0.4x0.7" or "0.4,0.4,0.7": width, depth and height in metres.
Result<Vec3> parse_size3(const std::string& text);

}  // namespace roomgen::cli
