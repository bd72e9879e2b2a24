#pragma once

#include <map>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "view/category_colors.h"

namespace roomgen::detail {

/// A line of a legend.
struct LegendEntry {
  std::string category;
  int count = 0;  ///< of things of that category
};

/// What is to be written beside a picture of segments.
struct Legend {
  std::vector<LegendEntry> entries;
  std::map<std::string, Rgb> colors;
  double pixels_per_metre = 100.0;
};

/// Its width beside a picture whose longer side is `pixels`.
int legend_width(int pixels);

/// The picture with the legend to its right.
Result<Image> with_legend(const Image& picture, const Legend& legend, int width);

}  // namespace roomgen::detail
