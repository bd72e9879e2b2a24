#include <algorithm>

#include "chain.h"
#include "checks.h"
#include "roomgen/geometry/polygon.h"
#include "rounds.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

// The point where two neighbouring sides meet again once both have moved inwards by `distance`.
Vec2 moved_corner(const Vec2& before, const Vec2& here, const Vec2& after, double distance) {
  const Vec2 n1 = left_of((here - before).normalized()), n2 = left_of((after - here).normalized());
  const Vec2 sum = n1 + n2;
  return here + distance * 2.0 / std::max(sum.squaredNorm(), 1e-6) * sum;
}

Loop inset(const Loop& loop, double distance) {
  const std::size_t n = loop.size();
  Loop result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(moved_corner(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], distance));
  return result;
}

bool keeps_its_sides(const Loop& loop, const Loop& moved) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t j = (i + 1) % loop.size();
    if ((loop[j] - loop[i]).dot(moved[j] - moved[i]) <= 0) return false;
  }
  return true;
}

bool cross_each_other(const Loop& a, const Loop& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (intersects(Segment{a[i], a[(i + 1) % a.size()]}, Segment{b[j], b[(j + 1) % b.size()]}))
        return true;
  return false;
}

bool any_cross(const std::vector<Loop>& loops) {
  for (std::size_t a = 0; a < loops.size(); ++a)
    for (std::size_t b = a + 1; b < loops.size(); ++b)
      if (cross_each_other(loops[a], loops[b])) return true;
  return false;
}

bool bevel_fits(const std::vector<Loop>& loops, double bevel) {
  std::vector<Loop> moved;
  for (const auto& loop : loops) {
    moved.push_back(inset(loop, bevel));
    if (!keeps_its_sides(loop, moved.back()) || !is_simple(moved.back())) return false;
  }
  return !any_cross(moved);
}

// The greatest bevel that leaves the outline one piece, found by halving.
double fitting_bevel(const std::vector<Loop>& loops, double bevel, double height) {
  bevel = std::min(bevel, 0.5 * height);
  while (bevel >= smallest_bevel && !bevel_fits(loops, bevel)) bevel *= 0.5;
  return bevel < smallest_bevel ? 0.0 : bevel;
}

// The side around one loop, its rows from the inset lower edge to the inset upper one.
void add_side(SurfaceBuilder& surface, const Chain2& chain, double height, double bevel,
              double tolerance) {
  Skin skin;
  skin.column_crease = chain.crease;
  if (bevel == 0.0) {
    skin.rows = {raised(chain.points, 0.0), raised(chain.points, height)};
    add_skin(surface, skin);
    return;
  }
  const int steps = std::max(2, arc_steps(pi / 2, bevel, tolerance));
  const auto row = [&](int k, bool upper) {
    const double angle = pi / 2 * k / steps;
    const double in = k == steps ? bevel : bevel * (1.0 - std::cos(angle));
    const double rise = k == steps ? bevel : bevel * std::sin(angle);
    const double z = upper ? height - bevel + rise : bevel - rise;
    return raised(k == 0 ? chain.points : inset(chain.points, in), z);
  };
  for (int k = steps; k >= 0; --k) skin.rows.push_back(row(k, false));
  for (int k = 0; k <= steps; ++k) skin.rows.push_back(row(k, true));
  skin.first_normal = -Vec3::UnitZ();
  skin.last_normal = Vec3::UnitZ();
  add_skin(surface, skin);
}

// Outline first, then the holes, clockwise.
Result<std::vector<Chain2>> boundaries(const Extrusion& solid, double tolerance) {
  auto outline = sample_outline(solid.outline, tolerance, "extrusion");
  if (!outline) return outline.error();
  std::vector<Chain2> chains{std::move(*outline)};
  for (const auto& hole : solid.holes) {
    auto chain = sample_outline(hole, tolerance, "extrusion, hole");
    if (!chain) return chain.error();
    if (!contains(Polygon{chains.front().points}, chain->points.front()))
      return input_error("extrusion: a hole lies outside the outline");
    for (std::size_t k = 1; k < chains.size(); ++k) {
      Loop other = chains[k].points;
      std::reverse(other.begin(), other.end());
      if (contains(Polygon{other}, chain->points.front()) ||
          contains(Polygon{chain->points}, other.front()))
        return input_error("extrusion: a hole lies in another");
    }
    reverse(*chain);
    chains.push_back(std::move(*chain));
  }
  return chains;
}

}  // namespace

Result<Mesh> mesh(const Extrusion& solid, double tolerance) {
  if (auto s = check_sizes("extrusion", {solid.height}); !s) return s.error();
  if (auto s = check_bevel("extrusion", solid.bevel); !s) return s.error();
  const auto chains = boundaries(solid, tolerance);
  if (!chains) return chains.error();
  std::vector<Loop> loops;
  for (const auto& chain : *chains) loops.push_back(chain.points);
  if (any_cross(loops)) return input_error("extrusion: the outline and its holes cross each other");

  const double bevel = fitting_bevel(loops, solid.bevel, solid.height);
  SurfaceBuilder surface;
  for (const auto& chain : *chains) add_side(surface, chain, solid.height, bevel, tolerance);
  if (bevel > 0)
    for (auto& loop : loops) loop = inset(loop, bevel);
  add_level_cap(surface, loops, 0.0, false);
  add_level_cap(surface, loops, solid.height, true);
  return surface.mesh();
}

}  // namespace roomgen::shape
