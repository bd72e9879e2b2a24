#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "roomgen/geometry/image.h"

namespace roomgen::shape {

using Rgb = Eigen::Vector3d;

/// Value noise in [0, 1) over the unit square that repeats after it: 1 unit is one image.
class Noise {
 public:
  Noise(int columns, int rows, std::uint64_t seed);
  double operator()(double u, double v) const;

 private:
  int columns_, rows_;
  std::vector<double> values_;
};

/// Three octaves of noise, the finer the fainter, in [0, 1).
class Clouds {
 public:
  Clouds(int columns, int rows, std::uint64_t seed);
  double operator()(double u, double v) const;

 private:
  Noise broad_, middle_, fine_;
};

/// 0 below `low`, 1 above `high`, smooth between.
double smooth_step(double low, double high, double x);
inline Rgb mixed(const Rgb& a, const Rgb& b, double t) {
  return a + t * (b - a);
}

/// An opaque image of what `color` (0 to 255) gives at (u, v), both in (0, 1), v downwards.
Image painted(int width, int height, const std::function<Rgb(double u, double v)>& color);

}  // namespace roomgen::shape
