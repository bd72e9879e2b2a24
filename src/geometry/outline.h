#pragma once

#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen {

/// Longest path that is read, in bytes, and most points that its outline may have.
inline constexpr std::size_t max_path_bytes = 4096;
inline constexpr std::size_t max_outline_points = 128;

/// The closed outline that a path of SVG 1.1 (section 8.3) draws: all its commands, one subpath,
/// curves as `arc_steps` straight lines each. The points are the path's own coordinates in its own
/// order, no point twice in succession. Errors say what is wrong and at which byte.
Result<std::vector<Vec2>> outline_of_path(std::string_view path, int arc_steps = 16);

/// What is left of an outline where normal . p <= offset, by cutting it along that line (Sutherland
/// and Hodgman). Exact for convex outlines and for those that the line meets twice.
std::vector<Vec2> clipped(const std::vector<Vec2>& outline, const Vec2& normal, double offset);

}  // namespace roomgen
