#pragma once

#include <cmath>
#include <initializer_list>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/base/text.h"

namespace roomgen::shape {

/// Sizes that the solids are made in: below, float coordinates no longer tell points apart.
inline constexpr double smallest_size = 1e-4, greatest_size = 1000.0;
/// Rounding finer than this is not worth a triangle.
inline constexpr double smallest_bevel = 2e-5;

inline Error input_error(const std::string& message) {
  return {Error::Kind::invalid_input, message};
}

inline Status check_tolerance(double tolerance) {
  if (std::isfinite(tolerance) && tolerance >= 1e-6) return {};
  return input_error("the tolerance must be at least a micrometre");
}

inline Status check_sizes(const char* what, std::initializer_list<double> sizes) {
  for (double size : sizes)
    if (!(size >= smallest_size && size <= greatest_size))
      return input_error(std::string(what) + ": the size " + format_number(size) +
                         " is not between 0.0001 and 1000 m");
  return {};
}

/// Of a body's two ends; one may be a point.
inline Status check_radii(const char* what, double bottom, double top) {
  for (double radius : {bottom, top})
    if (radius != 0.0 && !(radius >= smallest_size && radius <= greatest_size))
      return input_error(std::string(what) + ": a radius must be 0 or between 0.0001 and 1000 m");
  if (bottom == 0.0 && top == 0.0) return input_error(std::string(what) + ": both radii are 0");
  return {};
}

inline Status check_bevel(const char* what, double bevel) {
  if (bevel >= 0.0 && bevel <= greatest_size) return {};
  return input_error(std::string(what) + ": the bevel must not be negative");
}

}  // namespace roomgen::shape
