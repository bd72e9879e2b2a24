#pragma once

#include "roomgen/geometry/model.h"

namespace roomgen {

/// The mean of the surface by its area: where the weight of a hollow body is. Zero without an area.
Vec3 surface_centroid(const Mesh& mesh);

}  // namespace roomgen
