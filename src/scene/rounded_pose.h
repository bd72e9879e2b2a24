#pragma once

#include "roomgen/geometry/vec.h"

namespace roomgen {

/// A pose as files hold it: coordinates to 0.1 mm, yaw to 0.001 degrees in (-180, 180].
Vec3 rounded_position(const Vec3& position);
double rounded_yaw(double yaw);

}  // namespace roomgen
