#pragma once

#include <Eigen/Core>
#include <vector>

#include "roomgen/geometry/model.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::shape::detail {

/// p becomes linear * p + offset.
struct Placement {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 offset = Vec3::Zero();
};

/// Scale, rotation about X, Y, Z of the parent, then the move.
Placement placement(const Component& component);
/// About a vertical axis through `center`.
Placement turn(const Vec2& center, double angle);
Placement mirror(int axis);

/// A placement that turns space inside out flips the triangles, so that the outside stays outside.
/// Texture coordinates grow with the mesh.
void place(Mesh& mesh, const Placement& placement);

/// `mesh` and `other` have the same attributes.
void append_mesh(Mesh& mesh, const Mesh& other);

/// What a component has become so far: each copy is the bodies of the component.
using Copies = std::vector<std::vector<Body>>;

/// All but Cut. Precondition: the result's size was checked.
void apply(const Operation& operation, Copies& copies);

}  // namespace roomgen::shape::detail
