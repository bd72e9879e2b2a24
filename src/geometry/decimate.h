#pragma once

#include <cstddef>

#include "roomgen/geometry/model.h"

namespace roomgen {

/// A coarser mesh of at most `max_triangles`, by collapsing edges where that costs least (Garland and
/// Heckbert 1997, by meshoptimizer), and where that does not do, by merging vertices of a grid. Its
/// vertices are some of the mesh's; normals and uvs are dropped: meant for collision, not for the
/// eye. A mesh that is small enough is returned as it is.
Mesh decimated(const Mesh& mesh, std::size_t max_triangles);

}  // namespace roomgen
