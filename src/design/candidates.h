#pragma once

#include <vector>

#include "sketch.h"

namespace roomgen::design {

/// Poses worth a thought for `self` under these relations: along the walls for what wants an edge,
/// beside and around the targets, at places of a table's sides, else all over the room. `company`
/// is how many of its kind will share a table.
std::vector<Pose> candidates(const Sketch& sketch, const Object& self,
                             const Arrangement& arrangement, const std::vector<Relation>& relations,
                             int company);

}  // namespace roomgen::design
