#pragma once

#include <vector>

#include "site.h"

namespace roomgen::lab::detail {

/// A pose at a place that can be walked to from which all of a target's box is in the picture.
struct Viewpoint {
  GridNode node = 0;  ///< from which one steps freely to it
  CameraPose pose;
  double fixed_score = 0.0;  ///< what does not depend on how much of the target is hidden
  double most_score = 0.0;   ///< if as little as may be is hidden
};

struct DrawnViewpoints {
  bool any_place = false;         ///< to stand in the range of distances
  std::vector<Viewpoint> points;  ///< the most promising first
};

/// Draws places around the target without repetition, until `samples` of them have all of its box in the picture.
DrawnViewpoints draw_viewpoints(const TourSite& site, const Object& target, const ShortestWays& ways);

/// TourView::score of so many pixels.
double view_score(const TourOptions& options, double pixels, double fixed_score);
/// The other way round; 0 if even none score as much.
double pixels_that_score(const TourOptions& options, double score, double fixed_score);

}  // namespace roomgen::lab::detail
