#pragma once

#include <vector>

#include "camera.h"
#include "marks.h"
#include "roomgen/scene/room.h"

namespace roomgen::detail {

/// Puts labels into a picture so that their boxes stay inside it and apart from each other.
class LabelPlacer {
 public:
  LabelPlacer(double width, double height) : picture_(width, height) {}

  bool fits(const Vec2& center, const Vec2& size) const;
  /// Adds the label if it fits where it is.
  bool place(const Drawing::Label& label);
  const std::vector<Drawing::Label>& labels() const { return labels_; }

 private:
  Vec2 picture_;
  std::vector<Drawing::Label> labels_;
};

/// Adds grid lines, coordinates beside the room and the axes. Labels that find no place are left
/// out.
void lay_grid(const Room& room, const Camera& camera, bool paper_frame, double letter_height,
              LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes);

/// Adds "x,y" at crossings of grid lines where nothing is in the way.
void lay_grid_points(const Scene& scene, const Camera& camera, bool paper_frame,
                     double letter_height, LabelPlacer& placer,
                     std::vector<Drawing::Stroke>& strokes);

/// The ids of walls, doors and windows beside them, as far as there is room: outside, else inside.
void place_part_labels(const Room& room, const Camera& camera, double letter_height,
                       LabelPlacer& placer, bool inside_only = false);

}  // namespace roomgen::detail
