#pragma once

#include "roomgen/tour/tour.h"

namespace roomgen::detail {

Vec3 look_direction(double yaw, double pitch);

}  // namespace roomgen::detail
