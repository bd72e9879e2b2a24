#pragma once

#include "roomgen/lab/tour.h"

namespace roomgen::lab::detail {

/// Metres above the floor, of all rooms.
double lowest_ceiling(const Scene& scene);

Status check_tour_options(const Scene& scene, const TourOptions& options);

}  // namespace roomgen::lab::detail
