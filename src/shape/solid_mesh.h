#pragma once

#include "roomgen/base/result.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

/// The mesh of a solid as it is written. Precondition: no Group.
Result<Mesh> solid_mesh(const Solid& solid, double tolerance);

}  // namespace roomgen::shape::detail
