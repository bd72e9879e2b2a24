#include "standing.h"

#include <algorithm>

namespace roomgen::create::detail {

namespace {

// Where the mesh is below the height: its vertices and where its edges cross it.
void collect_below(const Mesh& mesh, double height, std::vector<Vec2>& points) {
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions[t[k]].cast<double>();
      const Vec3 b = mesh.positions[t[(k + 1) % 3]].cast<double>();
      if (a.z() <= height) points.push_back(a.head<2>());
      if ((a.z() <= height) != (b.z() <= height))
        points.push_back((a + (height - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
    }
}

}  // namespace

std::vector<Vec2> plan_outline(const Part& part) {
  std::vector<Vec2> points;
  for (const auto& p : part.solid.mesh().positions) points.push_back(p.head<2>().cast<double>());
  return convex_hull(std::move(points));
}

Standing standing(const std::vector<Part>& parts, double reach) {
  Standing result;
  result.low = 1e300;
  double volume = 0.0;
  for (const auto& part : parts) {
    result.low = std::min(result.low, part.box().low.z());
    // Sheets count a little, so that things without volume have a centre.
    const double weight = part.volume + 1e-9;
    result.centre_of_mass += weight * part.centroid.head<2>();
    volume += weight;
  }
  result.centre_of_mass /= volume;
  std::vector<Vec2> points;
  for (const auto& part : parts)
    if (part.box().low.z() <= result.low + reach)
      collect_below(part.solid.mesh(), result.low + reach, points);
  result.hull = convex_hull(std::move(points));
  for (const auto& point : result.hull) result.centre_of_ground += point;
  if (!result.hull.empty()) result.centre_of_ground /= static_cast<double>(result.hull.size());
  result.margin = depth_in(result.hull, result.centre_of_mass);
  return result;
}

}  // namespace roomgen::create::detail
