#pragma once

#include "base/random.h"
#include "geometry/facet.h"

namespace shapes {

inline roomgen::Vec3 random_place(roomgen::Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high);
  return {x, y, random.uniform(low, high)};
}

/// A triangle up to `size` across somewhere in a cube of 4 m; now and then a sliver or a point.
inline roomgen::Facet random_facet(roomgen::Random& random, double size) {
  const roomgen::Vec3 at = random_place(random, -2, 2);
  roomgen::Facet facet{at, at + random_place(random, -size, size), at + random_place(random, -size, size)};
  if (random.chance(0.05)) facet.c = 0.5 * (facet.a + facet.b);
  if (random.chance(0.02)) facet.b = facet.c = facet.a;
  return facet;
}

/// Triangles that have nothing to do with each other.
inline roomgen::Mesh random_soup(roomgen::Random& random, int count, double size) {
  roomgen::Mesh mesh;
  for (int k = 0; k < count; ++k) {
    const roomgen::Facet facet = random_facet(random, size);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& p : {facet.a, facet.b, facet.c}) mesh.positions.push_back(p.cast<float>());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace shapes
