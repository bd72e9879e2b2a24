#pragma once

#include <vector>

#include "svg_path.h"

/// The curves of SVG paths as straight lines: each gives the points behind its start, the last of
/// them its end.
namespace roomgen::detail {

std::vector<Vec2> flatten_quadratic(const Vec2& start, const Vec2& control, const Vec2& end,
                                    const SvgPathOptions& options);
std::vector<Vec2> flatten_cubic(const Vec2& start, const Vec2& first, const Vec2& second,
                                const Vec2& end, const SvgPathOptions& options);

/// What the command A says of its ellipse, and which of its four arcs is meant.
struct EllipticalArc {
  Vec2 radii = Vec2::Ones();
  double turn = 0.0;  ///< of the ellipse's first axis, radians
  bool large = false, sweep = false;
};

/// Radii that are too short for both ends grow (SVG 1.1, F.6.6).
std::vector<Vec2> flatten_arc(const Vec2& start, const EllipticalArc& arc, const Vec2& end,
                              const SvgPathOptions& options);

}  // namespace roomgen::detail
