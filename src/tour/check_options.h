#pragma once

#include "roomgen/tour/tour.h"

namespace roomgen::detail {

Status check_tour_options(const Scene& scene, const TourOptions& options);

}  // namespace roomgen::detail
