#pragma once

#include <cstddef>

#include "roomgen/geometry/mesh.h"

namespace roomgen {

/// A coarser mesh of at most `max_triangles`, by clustering vertices on a grid that is made coarser
/// until the bound holds (Rossignac and Borrel 1993). A smaller mesh is returned as it is. Normals and
/// uvs are dropped when vertices merge: meant for collision, not for the eye.
Mesh decimated(const Mesh& mesh, std::size_t max_triangles);

}  // namespace roomgen
