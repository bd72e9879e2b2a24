#include <algorithm>

#include "chain.h"
#include "checks.h"
#include "rounds.h"

namespace roomgen::shape {

namespace {

// How much of a corner's sides a fillet of radius 1 takes.
double fillet_reach(const Vec2& before, const Vec2& corner, const Vec2& after) {
  const Vec2 in = (corner - before).normalized(), out = (after - corner).normalized();
  return std::tan(0.5 * std::atan2(cross(in, out), in.dot(out)));
}

// The corner as an arc of this radius that touches both sides, all of whose points are smooth.
void add_fillet(Chain2& chain, const Vec2& before, const Vec2& corner, const Vec2& after,
                double radius, double tolerance) {
  const Vec2 in = (corner - before).normalized(), out = (after - corner).normalized();
  const double turn = std::atan2(cross(in, out), in.dot(out));
  const Vec2 start = corner - radius * std::tan(0.5 * turn) * in;
  const Vec2 center = start + radius * left_of(in);
  const int steps = std::max(2, arc_steps(turn, radius, tolerance));
  for (int k = 0; k <= steps; ++k)
    chain.add(center + rotated(start - center, turn * k / steps), false);
}

// The rims' rounding, as large as the profile has room for.
double fitting_bevel(const Frustum& solid, const Vec2& bottom, const Vec2& top) {
  const double low = fillet_reach({0.0, 0.0}, bottom, top);
  const double high = fillet_reach(bottom, top, {0.0, solid.height});
  double bevel = solid.bevel;
  if (bottom.x() > 0) bevel = std::min(bevel, bottom.x() / low);
  if (top.x() > 0) bevel = std::min(bevel, top.x() / high);
  const double reach = (bottom.x() > 0 ? low : 0.0) + (top.x() > 0 ? high : 0.0);
  return std::min(bevel, (top - bottom).norm() / reach);
}

}  // namespace

Result<Mesh> mesh(const Frustum& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s = check_bevel("frustum", solid.bevel); !s) return s.error();
  if (auto s = check_sizes("frustum", {solid.height}); !s) return s.error();
  if (auto s = check_radii("frustum", solid.bottom_radius, solid.top_radius); !s) return s.error();

  const Vec2 bottom(solid.bottom_radius, 0.0), top(solid.top_radius, solid.height);
  double bevel = fitting_bevel(solid, bottom, top);
  if (bevel < smallest_bevel) bevel = 0.0;
  Chain2 profile;
  const Vec2 foot(0.0, 0.0), head(0.0, solid.height);
  const auto add_rim = [&](const Vec2& before, const Vec2& rim, const Vec2& after) {
    if (bevel == 0.0 || rim.x() == 0.0)
      profile.add(rim, true);
    else
      add_fillet(profile, before, rim, after, bevel, tolerance);
  };
  profile.add(foot, false);
  add_rim(foot, bottom, top);
  add_rim(bottom, top, head);
  profile.add(head, false);
  return turned(profile, 2 * pi, tolerance);
}

}  // namespace roomgen::shape
