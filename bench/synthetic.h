#pragma once

#include <cstdint>

#include "roomgen/scene/problem.h"

namespace roomgen {

/// A made-up problem of any size.
struct SyntheticOptions {
  int objects = 20;
  double area_per_object = 3.0;  ///< floor area of the room divided by the number of objects, m2
  bool suggestions = false;      ///< give every object a suggested location
  std::uint64_t seed = 0;
};

/// A rectangular room (4 to 3) with a door, and groups of four: a wall cabinet, a table away from the
/// walls and two chairs around it, of sizes that vary by a fifth.
Problem synthetic_problem(const SyntheticOptions& options);

}  // namespace roomgen
