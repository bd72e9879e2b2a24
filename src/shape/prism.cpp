#include "checks.h"
#include "roomgen/shape/primitives.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

// Side 0 is the one between the first two corners: half a side to either hand of the front.
Loop corners(int sides, double radius) {
  Loop result;
  for (int k = 0; k < sides; ++k) {
    const double angle = -pi / 2 + 2 * pi * (k - 0.5) / sides;
    result.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return result;
}

}  // namespace

Result<Mesh> mesh(const Prism& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (solid.sides < 3 || solid.sides > 64) return input_error("prism: needs 3 to 64 sides");
  if (auto s = check_sizes("prism", {solid.height}); !s) return s.error();
  if (auto s = check_radii("prism", solid.bottom_radius, solid.top_radius); !s) return s.error();

  const Loop bottom = corners(solid.sides, solid.bottom_radius);
  const Loop top = corners(solid.sides, solid.top_radius);
  SurfaceBuilder surface;
  Skin skin;
  skin.rows = {raised(bottom, 0.0), raised(top, solid.height)};
  skin.column_crease.assign(bottom.size(), true);
  add_skin(surface, skin);
  if (solid.bottom_radius > 0) add_level_cap(surface, {bottom}, 0.0, false);
  if (solid.top_radius > 0) add_level_cap(surface, {top}, solid.height, true);
  return surface.mesh();
}

}  // namespace roomgen::shape
