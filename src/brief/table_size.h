#pragma once

#include "roomgen/geometry/vec.h"

namespace roomgen::brief {

/// A table of this usual size made large enough for so many seats (NKBA: 0.61 m for each), never
/// smaller than usual.
Vec3 table_for(const Vec3& usual, bool round, int seats);

}  // namespace roomgen::brief
