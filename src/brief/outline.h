#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "floor_shapes.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::brief {

/// What a prompt says of the shape of a floor.
struct SaidShape {
  std::string outline;                ///< of FloorShapes; empty: a rectangle
  std::vector<std::string> features;  ///< each as often as it is asked for
  std::optional<Range> proportion;    ///< longer side to shorter

  bool is_rectangle() const { return outline.empty() && features.empty(); }
};

/// How large an outline shall be: the sides of its box, or its area in the proportions of the box.
struct OutlineSize {
  Vec2 box = Vec2::Ones();
  std::optional<double> area;
};

/// A floor, its box from the origin.
struct Outline {
  Polygon polygon;
  std::vector<std::size_t> glazed;   ///< walls that are windows, as those of a bay
  std::vector<std::string> missing;  ///< features for which no wall is long enough
};

/// The outline of that shape, mirrored by chance. `size.area` is met exactly, as is the box without
/// it; a feature breaks a wall of the outline itself, never one of another feature.
Outline make_outline(const SaidShape& said, const FloorShapes& shapes, const OutlineSize& size,
                     Random random);

Outline rectangle_of(const Vec2& size);

/// Width and depth of that area and ratio (longer to shorter), the longer one along x where `wide`.
Vec2 box_of(double area, double ratio, bool wide);

}  // namespace roomgen::brief
