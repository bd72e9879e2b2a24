#include "centroid.h"

#include <Eigen/Geometry>

namespace roomgen {

Vec3 surface_centroid(const Mesh& mesh) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 b = mesh.positions[t[1]].cast<double>();
    const Vec3 c = mesh.positions[t[2]].cast<double>();
    const double weight = 0.5 * (b - a).cross(c - a).norm();
    sum += weight * (a + b + c) / 3.0;
    area += weight;
  }
  return area > 0.0 ? Vec3(sum / area) : Vec3(Vec3::Zero());
}

}  // namespace roomgen
