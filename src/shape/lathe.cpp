#include <algorithm>
#include <cmath>

#include "chain.h"
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

// The areas beside the axis that the profile goes around, each counter-clockwise; a profile that
// comes back to the axis has several.
std::vector<Loop> lobes(const Chain2& profile) {
  if (profile.closed) return {profile.points};
  std::vector<Loop> result;
  Loop lobe;
  for (const auto& p : profile.points) {
    lobe.push_back(p);
    if (p.x() > 0.0) continue;
    if (lobe.size() > 2) result.push_back(lobe);
    lobe = {p};
  }
  return result;
}

// The flat faces at the start and end of a part of a turn.
void add_faces(SurfaceBuilder& surface, const Chain2& profile, const Vec2& first, const Vec2& last) {
  auto loops = lobes(profile);
  std::vector<Vec3> points;
  for (const auto& loop : loops)
    for (const auto& p : loop) points.push_back(placed(p, first));
  const Vec2 start = -left_of(first), end = left_of(last);
  add_cap(surface, loops, points, {start.x(), start.y(), 0.0});

  points.clear();
  for (auto& loop : loops) {
    std::reverse(loop.begin(), loop.end());
    for (auto& p : loop) {
      points.push_back(placed(p, last));
      p.x() = -p.x();  // the other face is seen from the other side
    }
  }
  add_cap(surface, loops, points, {end.x(), end.y(), 0.0});
}

// Fillets end level but for the last bits.
bool is_disc(const Vec2& end, const Vec2& next) {
  return end.x() == 0.0 && next.x() > 0.0 && std::abs(end.y() - next.y()) < on_axis;
}

// Flat ends become caps, whose texture is not drawn together towards the axis.
void replace_discs(SurfaceBuilder& surface, Skin& skin, const Chain2& profile,
                   const std::vector<Vec2>& columns) {
  const auto add_disc = [&](const Vec2& rim, bool upward) {
    Loop loop;
    for (const auto& direction : columns) loop.push_back(rim.x() * direction);
    add_level_cap(surface, {loop}, rim.y(), upward);
  };
  const std::size_t n = profile.size();
  if (n > 3 && is_disc(profile.points[n - 1], profile.points[n - 2])) {
    add_disc(profile.points[n - 2], true);
    if (!profile.crease[n - 2]) skin.last_normal = Vec3::UnitZ();
    skin.rows.pop_back();
    skin.row_crease.pop_back();
  }
  if (skin.rows.size() > 2 && is_disc(profile.points[0], profile.points[1])) {
    add_disc(profile.points[1], false);
    if (!profile.crease[1]) skin.first_normal = -Vec3::UnitZ();
    skin.rows.erase(skin.rows.begin());
    skin.row_crease.erase(skin.row_crease.begin());
  }
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
  SurfaceBuilder surface;
  Skin skin;
  skin.row_crease = profile.crease;
  skin.rows_closed = profile.closed;
  skin.columns_closed = is_full(angle);
  for (const auto& p : profile.points) {
    auto& row = skin.rows.emplace_back();
    for (const auto& direction : columns) row.push_back(placed(p, direction));
  }
  if (!is_full(angle))
    add_faces(surface, profile, columns.front(), columns.back());
  else if (!profile.closed)
    replace_discs(surface, skin, profile, columns);
  add_skin(surface, skin);
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
  if (area < 0) reverse(*profile);
  for (const auto& lobe : lobes(*profile))
    if (!is_simple(lobe)) return input_error("lathe: the profile crosses itself");
  return turned(*profile, solid.angle, tolerance);
}

}  // namespace roomgen::shape
