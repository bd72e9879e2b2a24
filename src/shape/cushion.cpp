#include <algorithm>
#include <cmath>

#include "checks.h"
#include "cube_skin.h"
#include "roomgen/shape/primitives.h"
#include "rounds.h"

namespace roomgen::shape {

namespace {

// A superellipsoid |x/a|^p + |y/b|^p + |z/c|^p = 1, reached from the cube along rays from the
// middle.
class Superellipsoid {
 public:
  Superellipsoid(const Vec3& size, double power) : half_(0.5 * size), power_(power) {}

  Corner at(const Vec3& cube) const {
    double sum = 0.0;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = std::abs(cube[axis]);
      sum += std::pow(size, power_);
      gradient[axis] = std::copysign(std::pow(size, power_ - 1.0), cube[axis]) / half_[axis];
    }
    const Vec3 unit = cube * std::pow(sum, -1.0 / power_);
    return {unit.cwiseProduct(half_), Vec2::Zero(), gradient.normalized(), 0};
  }

  // How far chords between ticks are from the surface, over lines through faces' middles and
  // diagonals.
  double deviation(const std::vector<Tick>& ticks) const {
    double worst = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      for (int across = 0; across < 2; ++across)
        for (std::size_t k = 0; k + 1 < ticks.size(); ++k)
          for (double slope : {0.0, 1.0}) {
            const auto point = [&](double t) {
              Vec3 cube;
              cube[axis] = 1.0;
              cube[(axis + 1 + across) % 3] = t;
              cube[(axis + 2 - across) % 3] = slope * t;
              return cube;
            };
            worst = std::max(worst, sag(point(ticks[k].at), point(ticks[k + 1].at)));
          }
    return worst;
  }

 private:
  double sag(const Vec3& a, const Vec3& b) const {
    const Corner middle = at(0.5 * (a + b));
    const Vec3 chord = 0.5 * (at(a).position + at(b).position);
    return std::abs((middle.position - chord).dot(middle.normal));
  }

  Vec3 half_;
  double power_;
};

// Equal angles, drawn towards the cube's edges where boxy bodies bend most.
std::vector<Tick> angular_ticks(int half_count, double crowding) {
  std::vector<Tick> ticks;
  for (int k = half_count; k > 0; --k) {
    const double t = static_cast<double>(k) / half_count;
    const double drawn = 1.0 - std::pow(1.0 - t, crowding);
    ticks.push_back({k == half_count ? -1.0 : -std::tan(pi / 4 * drawn), 0.0});
  }
  ticks.push_back({0.0, 0.0});
  for (int k = half_count - 1; k >= 0; --k) ticks.push_back({-ticks[k].at, 0.0});
  return ticks;
}

Mesh superellipsoid(const Vec3& size, double softness, double tolerance) {
  constexpr int most = 32;
  const Superellipsoid body(size, 2.0 / softness);
  const double crowding = 1.0 + 0.8 * (1.0 - softness);
  auto ticks = angular_ticks(2, crowding);
  for (int n = 3; n <= most && body.deviation(ticks) > tolerance; ++n)
    ticks = angular_ticks(n, crowding);
  SurfaceBuilder surface;
  const Vec3 middle(0.0, 0.0, 0.5 * size.z());
  add_cube_skin(surface, ticks, [&](const Vec3& at, const Vec3&) {
    Corner corner = body.at(at);
    corner.position += middle;
    return corner;
  });
  return surface.mesh();
}

}  // namespace

Result<Mesh> mesh(const Ellipsoid& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s = check_sizes("ellipsoid", {solid.size.x(), solid.size.y(), solid.size.z()}); !s)
    return s.error();
  return superellipsoid(solid.size, 1.0, tolerance);
}

Result<Mesh> mesh(const Cushion& solid, double tolerance) {
  if (auto s = check_tolerance(tolerance); !s) return s.error();
  if (auto s = check_sizes("cushion", {solid.size.x(), solid.size.y(), solid.size.z()}); !s)
    return s.error();
  if (!(solid.softness >= 0.1 && solid.softness <= 1.0))
    return input_error("cushion: the softness must be between 0.1 and 1");
  return superellipsoid(solid.size, solid.softness, tolerance);
}

}  // namespace roomgen::shape
