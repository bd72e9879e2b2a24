#include "conventions.h"

namespace roomgen {

namespace {

Eigen::Matrix3d rows(double a, double b, double c, double d, double e, double f, double g, double h,
                     double i) {
  Eigen::Matrix3d m;
  m << a, b, c, d, e, f, g, h, i;
  return m;
}

}  // namespace

const std::vector<AxisConvention>& axis_conventions() {
  // Each row of a matrix is one of their axes in ours. Front -Y and up +Z become what the name says.
  static const std::vector<AxisConvention> table = {
      {"roomgen", rows(1, 0, 0, 0, 1, 0, 0, 0, 1), 1.0},
      {"blender", rows(1, 0, 0, 0, 1, 0, 0, 0, 1), 1.0},      // Z up, front -Y
      {"gltf", rows(1, 0, 0, 0, 0, 1, 0, -1, 0), 1.0},        // Y up, front +Z
      {"drake", rows(-1, 0, 0, 0, -1, 0, 0, 0, 1), 1.0},      // Z up, front +Y
      {"habitat", rows(-1, 0, 0, 0, 0, 1, 0, 1, 0), 1.0},     // Y up, front -Z
      {"unity", rows(-1, 0, 0, 0, 0, 1, 0, -1, 0), 1.0},      // left-handed, Y up, front +Z
      {"unreal", rows(0, -1, 0, -1, 0, 0, 0, 0, 1), 100.0},   // left-handed, Z up, front +X, cm
  };
  return table;
}

const AxisConvention* find_axis_convention(std::string_view name) {
  for (const auto& convention : axis_conventions())
    if (convention.name == name) return &convention;
  return nullptr;
}

}  // namespace roomgen
