#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawing.h"
#include "roomgen/base/result.h"

namespace roomgen::detail {

/// The lines of an SVG path (SVG 1.1, 8.3), in its own units: M, L, H, V, Z, and curves C, S, Q, T
/// and A as corners. Each M begins a new line. `line` is that of the file.
Result<std::vector<DrawnLine>> parse_svg_path(std::string_view data, const std::string& source,
                                              std::size_t line);

}  // namespace roomgen::detail
