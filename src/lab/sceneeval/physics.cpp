#include "physics.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/random.h"

namespace roomgen::lab::sceneeval {

namespace {

constexpr double points_per_cubic_metre = 5000.0;
constexpr double least_points = 1000.0;
constexpr double floor_tolerance = 1e-6;  // a ray that starts on the floor meets it

bool above_floor(const Vec3& point, const Room& room) {
  return point.z() >= -floor_tolerance && is_over_floor(point.head<2>(), room);
}

}  // namespace

bool is_over_floor(const Vec2& place, const Room& room) {
  constexpr double edge_tolerance = 1e-4;  // metres: what a scene file resolves
  return contains(room.polygon, place) || distance_to_boundary(room.polygon, place) <= edge_tolerance;
}

double share_in_bounds(const Thing& thing, const Room& room) {
  const Mesh& mesh = thing.mesh();
  std::vector<double> sums;
  double area = 0.0;
  const auto corner = [&](const Triangle& t, int i) -> Vec3 {
    return mesh.positions[t[static_cast<std::size_t>(i)]].cast<double>();
  };
  for (const auto& t : mesh.triangles) {
    area += 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    sums.push_back(area);
  }
  if (area <= 0.0) return 1.0;
  const int count = static_cast<int>(
      std::max(thing.box().volume() * points_per_cubic_metre, least_points));
  Random random(0);
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    // Even over the area, by chance within the triangle.
    const double at = area * (i + random.uniform()) / count;
    const auto found = std::lower_bound(sums.begin(), sums.end(), at);
    const auto& t = mesh.triangles[std::min<std::size_t>(
        static_cast<std::size_t>(found - sums.begin()), mesh.triangles.size() - 1)];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Vec3 p = corner(t, 0) + u * (corner(t, 1) - corner(t, 0)) + v * (corner(t, 2) - corner(t, 0));
    if (above_floor(p, room)) ++inside;
  }
  return static_cast<double>(inside) / count;
}

}  // namespace roomgen::lab::sceneeval
