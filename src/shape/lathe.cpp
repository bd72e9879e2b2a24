#include "lathe.h"

#include <algorithm>

#include "checks.h"
#include "roomgen/geometry/polygon.h"
#include "rounds.h"
#include "skin.h"

namespace roomgen::shape {

namespace {

constexpr double on_axis = 1e-6;

bool is_full(double angle) {
  return angle > 2 * pi - 1e-6;
}

// Where the columns stand: from the back right round, or over a part of it that leaves the front
// open.
std::vector<Vec2> directions(double angle, double radius, double tolerance) {
  const int sides = circle_sides(radius, tolerance);
  if (is_full(angle)) return circle(sides);
  const int steps = std::max(2, static_cast<int>(std::ceil(sides * angle / (2 * pi))));
  std::vector<Vec2> result;
  for (int k = 0; k <= steps; ++k)
    result.push_back(rotated(Vec2(0.0, 1.0), angle * (static_cast<double>(k) / steps - 0.5)));
  return result;
}

Vec3 placed(const Vec2& profile_point, const Vec2& direction) {
  return {profile_point.x() * direction.x(), profile_point.x() * direction.y(), profile_point.y()};
}

// The flat faces at the start and end of a part of a turn.
void add_faces(Surface& surface, const Chain2& profile, const Vec2& first, const Vec2& last) {
  Loop loop = profile.points;
  std::vector<Vec3> points;
  for (const auto& p : loop) points.push_back(placed(p, first));
  const Vec2 start = -left_of(first), end = left_of(last);
  add_cap(surface, {loop}, points, {start.x(), start.y(), 0.0});

  std::reverse(loop.begin(), loop.end());
  points.clear();
  for (auto& p : loop) {
    points.push_back(placed(p, last));
    p.x() = -p.x();  // the other face is seen from the other side
  }
  add_cap(surface, {loop}, points, {end.x(), end.y(), 0.0});
}

Result<Chain2> checked_profile(const Lathe& solid, double tolerance) {
  auto profile = sample(solid.profile, tolerance);
  if (!profile) return with_context(profile.error(), "lathe");
  double greatest = 0.0;
  for (auto& p : profile->points) {
    if (p.x() < -on_axis) {
      // Smooth curves may swing a little over the axis between points that do not.
      for (const auto& given : solid.profile.points)
        if (given.x() < -on_axis) return input_error("lathe: a radius of the profile is negative");
    }
    if (p.x() < on_axis) p.x() = 0.0;
    greatest = std::max(greatest, p.x());
  }
  if (greatest < smallest_size) return input_error("lathe: the profile has no width");
  return profile;
}

// Flat discs lead from the ends of an open profile to the axis.
void join_to_axis(Chain2& profile) {
  if (profile.points.front().x() > 0) {
    profile.crease.front() = true;
    profile.points.insert(profile.points.begin(), Vec2(0.0, profile.points.front().y()));
    profile.crease.insert(profile.crease.begin(), false);
  }
  if (profile.points.back().x() > 0) {
    profile.crease.back() = true;
    profile.add({0.0, profile.points.back().y()}, false);
  }
}

}  // namespace

Mesh turned(const Chain2& profile, double angle, double tolerance) {
  double radius = 0.0;
  for (const auto& p : profile.points) radius = std::max(radius, p.x());
  const auto columns = directions(angle, radius, tolerance);
  Surface surface;
  Skin skin;
  skin.row_crease = profile.crease;
  skin.rows_closed = profile.closed;
  skin.columns_closed = is_full(angle);
  for (const auto& p : profile.points) {
    auto& row = skin.rows.emplace_back();
    for (const auto& direction : columns) row.push_back(placed(p, direction));
  }
  add_skin(surface, skin);
  if (!is_full(angle)) add_faces(surface, profile, columns.front(), columns.back());
  return surface.mesh();
}

Result<Mesh> mesh(const Lathe& solid, double tolerance) {
  if (!(solid.angle > 0.01 && solid.angle < 2 * pi + 1e-6))
    return input_error("lathe: the angle must be between 0 and a full turn");
  auto profile = checked_profile(solid, tolerance);
  if (!profile) return profile.error();
  if (!profile->closed) join_to_axis(*profile);
  const double area = signed_area(profile->points);
  if (std::abs(area) < 1e-9) return input_error("lathe: the profile encloses no area");
  if (!is_simple(profile->points)) return input_error("lathe: the profile crosses itself");
  if (area < 0) reverse(*profile);
  return turned(*profile, solid.angle, tolerance);
}

}  // namespace roomgen::shape
