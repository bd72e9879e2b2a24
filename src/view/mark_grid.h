#pragma once

#include "label_placer.h"

namespace roomgen::detail {

/// Adds grid lines, coordinates beside the room and the axes. Labels that find no place are left
/// out.
void lay_grid(const Room& room, const Camera& camera, bool paper_frame, double letter_height,
              LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes);

/// Adds "x,y" at crossings of grid lines where nothing is in the way.
void lay_grid_points(const Scene& scene, const Camera& camera, bool paper_frame,
                     double letter_height, LabelPlacer& placer,
                     std::vector<Drawing::Stroke>& strokes);

}  // namespace roomgen::detail
