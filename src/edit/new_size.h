#pragma once

#include <optional>
#include <string>

#include "roomgen/geometry/vec.h"

namespace roomgen {

/// Which side of a thing changes, and how.
struct NewSize {
  std::string side;                  ///< as Growth::side
  double factor = 0.0;               ///< of the side; 0: not said
  std::optional<double> more, exact; ///< metres
};
Vec3 resized(const Vec3& size, const NewSize& change);

/// The side that is called so: "height", "depth", "width", else the longer one.
double& side_of_size(Vec3& size, const std::string& side);

}  // namespace roomgen
