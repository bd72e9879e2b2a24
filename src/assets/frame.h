#pragma once

#include <Eigen/Core>
#include <optional>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

namespace roomgen::assets {

/// How a mesh file sees the world.
struct SourceFrame {
  Eigen::Matrix3d ours_from_source = Eigen::Matrix3d::Identity();  ///< orthonormal
  double metres_per_unit = 0.0;  ///< 0: unknown, guessed from how large the thing is
  std::optional<Vec3> size;      ///< known box (width, depth, height in metres); wins over units
};

/// The matrix of an up and a front direction, each "+x" … "-z"; a frame for which they are parallel
/// or misspelt is an error. The thing's own width direction follows.
Result<Eigen::Matrix3d> ours_from_axes(const std::string& up, const std::string& front);

enum class Normals { repair, leave };

/// Brings an imported model into the frame of Model: turned, in metres, its box exactly the wanted
/// size, origin at the bottom centre, degenerate triangles gone, normals whole (or left as they
/// are, for who only measures). Fails if nothing is left. Returns the box.
Result<Vec3> fit_to_frame(Model& model, const SourceFrame& frame,
                          Normals normals = Normals::repair);

}  // namespace roomgen::assets
