#include <algorithm>

#include "checks.h"
#include "cube_skin.h"
#include "roomgen/shape/primitives.h"
#include "rounds.h"

namespace roomgen::shape {

namespace {

// Lines of a rounded box's face: those of an eighth of a circle on either side of the flat.
std::vector<Tick> rounded_ticks(int steps) {
  std::vector<Tick> ticks;
  for (int k = steps; k >= 0; --k)
    ticks.push_back({k == steps ? -1.0 : -std::tan(pi / 4 * k / steps), -1.0});
  for (int k = 0; k <= steps; ++k) ticks.push_back({-ticks[steps - k].at, 1.0});
  return ticks;
}

// Half of the steps of a quarter round, which ends in the middle of its edge.
int half_steps(double bevel, double tolerance) {
  return std::min(16, (arc_steps(pi / 2, bevel, tolerance) + 1) / 2);
}

}  // namespace

Result<Mesh> mesh(const Box& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s = check_sizes("box", {solid.size.x(), solid.size.y(), solid.size.z()}); !s)
    return s.error();
  if (auto s = check_bevel("box", solid.bevel); !s) return s.error();

  const Vec3 half = 0.5 * solid.size;
  double bevel = std::min(solid.bevel, half.minCoeff());
  if (bevel < smallest_bevel) bevel = 0.0;
  const Vec3 inner = (half.array() - bevel).matrix(), middle(0.0, 0.0, half.z());
  SurfaceBuilder surface;
  if (bevel == 0.0) {
    add_cube_skin(surface, {{-1.0, -1.0}, {1.0, 1.0}}, [&](const Vec3&, const Vec3& side) {
      return Corner{middle + side.cwiseProduct(half), Vec2::Zero(), Vec3::Zero(), 0};
    });
  } else {
    add_cube_skin(surface, rounded_ticks(half_steps(bevel, tolerance)),
                  [&](const Vec3& at, const Vec3& side) {
                    const Vec3 normal = at.normalized();
                    return Corner{middle + side.cwiseProduct(inner) + bevel * normal, Vec2::Zero(),
                                  normal, 0};
                  });
  }
  return surface.mesh();
}

Result<Mesh> mesh(const Plane& solid, double tolerance) {
  return mesh(Box{{solid.size.x(), solid.size.y(), solid.thickness}, 0.0}, tolerance);
}

}  // namespace roomgen::shape
