#pragma once

#include "roomgen/lab/tour.h"
#include "walk_grid.h"

namespace roomgen::lab::detail {

/// What stays the same for all targets of a tour.
struct TourSite {
  const Scene& scene;
  const ModelTable& models;
  const TourOptions& options;
  const FreeSpace& space;
  const WalkGrid& grid;

  TourIntrinsics intrinsics() const { return {options.width, options.height, options.field_of_view}; }
};

}  // namespace roomgen::lab::detail
