#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"

namespace roomgen {

/// A run of an SVG path from one M to the next, or behind a Z.
struct SvgSubpath {
  std::vector<Vec2> points;  ///< a Z adds none
  bool closed = false;       ///< by a Z
};

/// How finely curves are drawn, and how much is read.
struct SvgPathOptions {
  int curve_steps = 16;   ///< lines of a Bezier curve, at least 1
  double arc_step = 0.0;  ///< radians of an arc that are one line; 0: `curve_steps` lines, too
  std::size_t most_points = 20000;
  std::size_t most_subpaths = std::numeric_limits<std::size_t>::max();
  double greatest = std::numeric_limits<double>::max();  ///< number, either way
};

/// The lines that a path of SVG 1.1 (section 8.3) draws, with all its commands, in its own units and
/// its own order. Errors say what is wrong and at which byte.
Result<std::vector<SvgSubpath>> read_svg_path(std::string_view path,
                                              const SvgPathOptions& options = {});

}  // namespace roomgen
