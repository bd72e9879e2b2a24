#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace roomgen {

/// How another program sees the world, against ours (right-handed, Z up, front -Y, metres).
struct AxisConvention {
  std::string_view name;
  /// Its coordinates of our unit axes: p_theirs = theirs_from_ours * p_ours. Determinant -1 means
  /// left-handed.
  Eigen::Matrix3d theirs_from_ours;
  double units_per_metre;
};

/// The one table of conversions (glTF 2.0 section 3.3; Blender; Unity; Unreal; Habitat; Drake).
const std::vector<AxisConvention>& axis_conventions();
/// Null if there is no convention of this name.
const AxisConvention* find_axis_convention(std::string_view name);

}  // namespace roomgen
