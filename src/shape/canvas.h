#pragma once

#include <vector>

#include "noise.h"
#include "roomgen/geometry/model.h"

namespace roomgen::shape {

using Outlines = std::vector<std::vector<Vec2>>;

/// An opaque image that is painted area by area, its edges smooth: four rows of samples for each
/// row of pixels, exact along them.
class Canvas {
 public:
  Canvas(int width, int height, const Tint& ground);
  /// What the closed outlines (pixels, y downwards) wind around, together.
  void fill(const Outlines& outlines, const Tint& color, double opacity);
  Image image() const;

 private:
  struct Crossing {
    double x = 0.0;
    int turn = 0;
  };
  using Rows = std::vector<std::vector<Crossing>>;
  Rows crossings(const Outlines& outlines, int low, int high) const;

  int width_, height_;
  std::vector<Tint> pixels_;
};

/// The outlines of a pen's way of this width, round at its ends and corners.
Outlines pen_outlines(const std::vector<Vec2>& points, bool closed, double width);

}  // namespace roomgen::shape
