#pragma once

#include <optional>
#include <vector>

#include "geometry/triangulate.h"
#include "surface.h"

namespace roomgen::shape {

/// A grid of points over a body: rows follow each other along it, the columns of a row run around
/// it counter-clockwise as seen from where the rows lead, so that the outside is outside.
struct Skin {
  std::vector<std::vector<Vec3>> rows;
  std::vector<bool> row_crease, column_crease;  ///< empty: none
  bool rows_closed = false, columns_closed = true;
  /// What the skin runs into at its ends, when it does so without a crease.
  std::optional<Vec3> first_normal, last_normal;
};
void add_skin(SurfaceBuilder& surface, const Skin& skin);

/// The flat area between the loops, as seen from the side of `normal`: `points` are the loops'
/// points one after the other in space, `loops` the same in the plane.
void add_cap(SurfaceBuilder& surface, const std::vector<Loop>& loops, const std::vector<Vec3>& points,
             const Vec3& normal);
/// The same between level loops (counter-clockwise from above, holes clockwise) at height `z`.
void add_level_cap(SurfaceBuilder& surface, std::vector<Loop> loops, double z, bool upward);

std::vector<Vec3> raised(const Loop& loop, double z);

}  // namespace roomgen::shape
