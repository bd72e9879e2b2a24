#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "geometry/facet.h"

namespace roomgen {

/// A closed mesh prepared for questions about what is near it. What takes time (a bounding-volume
/// tree) is made when first asked for and shared by copies. Not for use by two threads at once.
class MeshSolid {
 public:
  /// Triangles face outwards. Several closed surfaces in one mesh, also overlapping ones, count as
  /// one solid.
  explicit MeshSolid(Mesh mesh);

  const Mesh& mesh() const;
  const Bounds3& box() const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

/// The nearest points of two solids. Solids that share space, also one inside the other, have the
/// distance 0 and two equal points that lie in both. Nothing when they are further apart than
/// `limit` metres, which is found out faster than a distance.
std::optional<NearestPoints> nearest_points(const MeshSolid& a, const MeshSolid& b,
                                            double limit = std::numeric_limits<double>::infinity());

/// Are they no further apart than `limit` metres? Found out faster than their nearest points.
bool within(const MeshSolid& a, const MeshSolid& b, double limit);

/// Is the point in the solid?
bool contains(const MeshSolid& solid, const Vec3& point);
/// To the solid's surface; 0 inside.
double distance(const MeshSolid& solid, const Vec3& point);

/// What contact_area() looks at.
struct AreaOptions {
  Bounds3 within = {Vec3::Constant(-1e300), Vec3::Constant(1e300)};
  double enough = std::numeric_limits<double>::infinity();  ///< the sum stops here
};

/// About how much of a's surface is in b or within `near` metres of it, square metres: sampled,
/// true to a few percent of flat contacts.
double contact_area(const MeshSolid& a, const MeshSolid& b, double near,
                    const AreaOptions& options = {});

/// Between the boxes; 0 when they overlap.
double box_distance(const Bounds3& a, const Bounds3& b);

}  // namespace roomgen
