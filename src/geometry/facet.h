#pragma once

#include <optional>

#include "roomgen/geometry/model.h"

namespace roomgen {

/// One triangle of a mesh by its corners, counter-clockwise seen from outside. It may be a sliver,
/// or a point.
struct Facet {
  Vec3 a, b, c;
};

Facet facet(const Mesh& mesh, const Triangle& triangle);
Bounds3 bounds(const Facet& facet);
/// The facet's point that is nearest to `point`.
Vec3 closest_point(const Facet& facet, const Vec3& point);

struct Ray {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< of any length
};

/// Where the line of a ray crosses a facet.
struct FacetCrossing {
  double at = 0.0;       ///< in lengths of the direction; negative behind the origin
  bool outward = false;  ///< it leaves by the outer side
};

/// Nothing for a line in the facet's plane. The facet counts as larger by the share `slack` of its
/// edges, so that no line slips through between two neighbours.
std::optional<FacetCrossing> crossing(const Facet& facet, const Ray& ray, double slack = 0.0);

/// The nearest points of two things. Where they share space the distance is 0.
struct NearestPoints {
  double distance = 0.0;
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
};

/// Of facets that cross, a common point of both.
NearestPoints nearest_points(const Facet& a, const Facet& b);

}  // namespace roomgen
