#pragma once

#include "roomgen/lab/tour.h"

namespace roomgen::lab::detail {

Vec3 look_direction(double yaw, double pitch);

}  // namespace roomgen::lab::detail
